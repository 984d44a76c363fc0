// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/planar_walk.h"

#include "croquis/geometry/predicates.h"

namespace croquis::silhouette {

Index PlanarWalk::locate(const Vec2& place) {
  // The first of a triangle's edges, beginning with that opposite to a corner, that has the place strictly on its
  // right; 3 for none.
  const auto edge_before = [&](Index triangle, Index from) -> Index {
    const std::array<Index, 3>& corners = triangulation_->triangles[triangle];
    for (Index k = from; k < from + 3; ++k) {
      const Vec2& a = (*points_)[corners[(k + 1) % 3]];
      const Vec2& b = (*points_)[corners[(k + 2) % 3]];
      if (orientation(a, b, place) < 0) return k % 3;
    }
    return 3;
  };
  const auto count = static_cast<Index>(triangulation_->triangles.size());
  Index triangle = last_;
  // Constrained triangulations can send such a walk round in cycles: it changes its preference at every step and has
  // a bound.
  for (Index step = 0; step < count; ++step) {
    const Index corner = edge_before(triangle, step % 3);
    if (corner == 3) return last_ = triangle;
    triangle = triangulation_->neighbours[triangle][corner];
    if (triangle == no_index) return no_index;  // the hull is convex: beyond one edge of it is outside
  }
  for (triangle = 0; triangle < count; ++triangle) {
    if (edge_before(triangle, 0) == 3) return triangle;
  }
  return no_index;
}

}  // namespace croquis::silhouette
