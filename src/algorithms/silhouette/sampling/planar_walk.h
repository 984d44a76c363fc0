// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/planar_triangulation.h"

namespace croquis::silhouette {

/// Finds the triangle of a triangulation that holds a place, by walking towards it from the last one found: quick for
/// places that follow each other. Exact; a place on an edge belongs to any triangle there.
class PlanarWalk {
 public:
  /// Both are only read and must outlive the walk.
  PlanarWalk(const std::vector<Vec2>& points, const PlanarTriangulation& triangulation)
      : points_(&points), triangulation_(&triangulation) {}

  /// The triangle, or no_index outside of the convex hull.
  Index locate(const Vec2& place);

 private:
  const std::vector<Vec2>* points_;
  const PlanarTriangulation* triangulation_;
  Index last_ = 0;
};

}  // namespace croquis::silhouette
