// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/sheet_walk.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"
#include "croquis/geometry/predicates.h"

namespace croquis::silhouette {

/// Where a walk stands: at a vertex, or about to enter a triangle.
struct SheetWalk::State {
  Vec2 start;
  Vec2 target;
  Index vertex = no_index;    ///< lifted; no_index between vertices
  Index triangle = no_index;  ///< lifted, about to be entered …
  Index entry = 0;            ///< … across the edge opposite to this corner
  double along = 0;
  bool arrived = false;
  std::vector<WalkStep> steps = {};

  int side(const Vec2& point) const { return orientation(start, target, point); }

  double fraction(const Vec2& point) const {
    const Vec2 way = target - start;
    return (point - start).dot(way) / way.squaredNorm();
  }

  /// Where the line crosses the line through two points.
  double fraction(const Vec2& a, const Vec2& b) const { return crossing_fraction(start, target, a, b); }

  /// For points on the line: not before the target.
  bool reaches_target(const Vec2& point) const {
    const Vec2 way = target - start;
    const Eigen::Index axis = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1;
    return way[axis] > 0 ? point[axis] >= target[axis] : point[axis] <= target[axis];
  }

  /// @param leave where the walk leaves these triangles, unless it ends in them
  void step_through(std::initializer_list<Index> triangles, double leave) {
    const double end = arrived ? 1 : std::clamp(leave, along, 1.0);
    for (const Index one : triangles) {
      if (one != no_index) steps.push_back({one, along, end});
    }
    along = end;
  }
};

SheetWalk::SheetWalk(std::span<const Vec2> points, const LiftedTriangulation& lifted)
    : points_(points), lifted_(lifted), first_corner_(lifted.planar_vertex.size(), no_index) {
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    for (Index corner = 0; corner < 3; ++corner) {
      // A fan that doesn't close begins where no triangle lies on the right.
      const bool begins = lifted.neighbours[m][previous(corner)] == no_index;
      Index& first = first_corner_[lifted.triangles[m][corner]];
      if (first == no_index || begins) first = 3 * m + corner;
    }
  }
}

/// Looks round a vertex, counter-clockwise, for the triangle whose angle the line enters.
void SheetWalk::pass_vertex(State& state) const {
  Index triangle = first_corner_[state.vertex] / 3, corner = first_corner_[state.vertex] % 3;
  for (;;) {
    const std::array<Index, 3>& corners = lifted_.triangles[triangle];
    const Vec2& right = point(corners[next(corner)]);
    const Vec2& left = point(corners[previous(corner)]);
    const int side_of_right = state.side(right), side_of_left = state.side(left);
    if (side_of_right > 0 || side_of_left < 0) {
      const Index following = lifted_.neighbours[triangle][next(corner)];
      if (following == no_index || following == first_corner_[state.vertex] / 3) {
        throw_internal("a chord leaves the region that it belongs to");
      }
      corner = next(corner_across(lifted_.neighbours, following, triangle));
      triangle = following;
    } else if (side_of_right == 0 || side_of_left == 0) {
      const Index end = side_of_right == 0 ? next(corner) : previous(corner);
      state.vertex = corners[end];
      state.arrived = state.reaches_target(point(state.vertex));
      state.step_through({triangle, lifted_.neighbours[triangle][3 - corner - end]},
                         state.fraction(point(state.vertex)));
      return;
    } else {
      state.vertex = no_index;
      state.triangle = triangle;
      state.arrived = orientation(right, left, state.target) >= 0;
      state.step_through({triangle}, state.fraction(right, left));
      return enter_beyond(state, corner);
    }
  }
}

void SheetWalk::cross_triangle(State& state) const {
  if (state.triangle == no_index) throw_internal("a chord leaves the region that it belongs to");
  const std::array<Index, 3>& corners = lifted_.triangles[state.triangle];
  const Vec2& apex = point(corners[state.entry]);
  // Seen along the walk: the entry edge's end on the left comes next after the apex.
  const Vec2& left = point(corners[next(state.entry)]);
  const Vec2& right = point(corners[previous(state.entry)]);
  state.arrived = orientation(right, apex, state.target) >= 0 && orientation(apex, left, state.target) >= 0;
  const int side = state.side(apex);
  if (side == 0) {
    state.step_through({state.triangle}, state.fraction(apex));
    state.vertex = corners[state.entry];
  } else if (side > 0) {
    state.step_through({state.triangle}, state.fraction(right, apex));
    enter_beyond(state, next(state.entry));
  } else {
    state.step_through({state.triangle}, state.fraction(apex, left));
    enter_beyond(state, previous(state.entry));
  }
}

/// Goes on to the triangle across the edge opposite to a corner.
void SheetWalk::enter_beyond(State& state, Index corner) const {
  const Index left = std::exchange(state.triangle, lifted_.neighbours[state.triangle][corner]);
  if (state.triangle != no_index) state.entry = corner_across(lifted_.neighbours, state.triangle, left);
}

std::vector<WalkStep> SheetWalk::walk(Index from, const Vec2& target) const {
  State state{point(from), target, from};
  while (!state.arrived) {
    if (state.vertex != no_index) {
      pass_vertex(state);
    } else {
      cross_triangle(state);
    }
  }
  return std::move(state.steps);
}

}  // namespace croquis::silhouette
