// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>
#include <string>
#include <utility>
#include <vector>

#include "croquis/geometry/bicubic_spline.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/rational_cubic.h"
#include "croquis/perspective/bicubic_fit.h"

/// B-reps, curves and surfaces in OpenCASCADE's terms, exactly.
namespace croquis {

/// A curve with the parameters that an edge has of it.
struct StepCurve {
  Handle(Geom_Curve) curve;
  double last = 1;  ///< the first is 0
};

gp_Pnt to_point(const Vec3& p);

/// A line where the one cubic runs along it at constant speed, else a B-spline curve, rational where the cubics are.
/// @param cubics each begins where the one before ends
StepCurve step_curve(const std::vector<RationalCubic>& cubics);

Handle(Geom_Surface) step_plane(const Vec3& origin, const Vec3& normal);
Handle(Geom_Surface) step_surface(const BicubicSpline& spline);

/// The straight line between two places of a surface's parameters, over 0..last at constant speed.
Handle(Geom2d_Curve) line_on_surface(const Vec2& from, const Vec2& to, double last);

/// A B-rep in OpenCASCADE's terms.
struct StepShape {
  TopoDS_Shape shape;                                       ///< a solid, an open shell, or a compound of these
  std::vector<std::pair<TopoDS_Shape, std::string>> names;  ///< of faces and edges
  std::size_t faces = 0, edges = 0;
};

/// A face of n patches becomes n faces; the edges around it are cut in their middles, on both sides of each.
/// @param fits per face and patch, see fit_patches
/// @param face_names of the B-rep's faces; may be empty
StepShape step_shape(const Brep& brep, const std::vector<std::vector<BicubicFit>>& fits,
                     const std::vector<std::string>& face_names);

}  // namespace croquis
