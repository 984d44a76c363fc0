// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/figure/arrangement.h"
#include "croquis/geometry/planar_triangulation.h"

namespace croquis::silhouette {

/// The faces of an arrangement: connected pieces of the plane without its contours. Face 0 is outside all.
struct Faces {
  PlanarTriangulation triangulation;  ///< of the arrangement's points, constrained to its segments
  std::vector<Index> of_triangle;
  std::vector<double> area;               ///< per face; 0 of face 0
  std::vector<std::vector<int>> winding;  ///< per face and contour: times the contour goes round it
  std::vector<Index> left;                ///< per arc
  std::vector<Index> right;
};

struct FacesResult {
  Faces faces;
  std::vector<Vec2> conflicts;  ///< places where contours overlap or meet in one point; then there are no faces
};

/// Triangulates the arrangement and floods it from outside, so that nested contours need no special care.
FacesResult find_faces(const Arrangement& arrangement);

}  // namespace croquis::silhouette
