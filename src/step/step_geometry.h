// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Pnt.hxx>
#include <vector>

#include "croquis/geometry/bicubic_spline.h"
#include "croquis/geometry/rational_cubic.h"

/// Curves and surfaces in OpenCASCADE's terms, exactly.
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

}  // namespace croquis
