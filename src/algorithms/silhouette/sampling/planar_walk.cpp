// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/planar_walk.h"

#include "croquis/geometry/predicates.h"

namespace croquis::silhouette {

/// The first of the edges opposite to corners from, from + 1, from + 2 that has the place strictly on its right; 3 for
/// none.
int PlanarWalk::first_edge_beyond(Index triangle, const Vec2& place, Index from) const {
  const std::array<Index, 3>& corners = triangulation_->triangles[triangle];
  for (Index k = 0; k < 3; ++k) {
    const Index corner = (from + k) % 3;
    const Vec2& a = (*points_)[corners[(corner + 1) % 3]];
    const Vec2& b = (*points_)[corners[(corner + 2) % 3]];
    if (orientation(a, b, place) < 0) return static_cast<int>(corner);
  }
  return 3;
}

Index PlanarWalk::locate(const Vec2& place) {
  const std::size_t count = triangulation_->triangles.size();
  if (count == 0) return no_index;
  Index triangle = last_;
  // Constrained triangulations can send such a walk round in cycles: it changes its preference at every step and has
  // a bound.
  for (std::size_t step = 0; step < count; ++step) {
    const int corner = first_edge_beyond(triangle, place, static_cast<Index>(step % 3));
    if (corner == 3) return last_ = triangle;
    const Index next = triangulation_->neighbours[triangle][static_cast<std::size_t>(corner)];
    if (next == no_index) return no_index;  // the hull is convex: beyond one edge of it is outside
    triangle = next;
  }
  return locate_by_search(place);
}

Index PlanarWalk::locate_by_search(const Vec2& place) const {
  for (Index triangle = 0; triangle < triangulation_->triangles.size(); ++triangle) {
    if (first_edge_beyond(triangle, place, 0) == 3) return triangle;
  }
  return no_index;
}

}  // namespace croquis::silhouette
