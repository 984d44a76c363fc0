// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <utility>
#include <vector>

#include "croquis/geometry/brep.h"
#include "croquis/perspective/bicubic_fit.h"

namespace croquis {

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
