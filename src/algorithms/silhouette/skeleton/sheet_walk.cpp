// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/sheet_walk.h"

#include <algorithm>
#include <cmath>

#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/base/error.h"
#include "croquis/geometry/predicates.h"

namespace croquis::silhouette {
namespace {

Index corner_across(const LiftedTriangulation& lifted, Index triangle, Index neighbour) {
  const std::array<Index, 3>& around = lifted.neighbours[triangle];
  return static_cast<Index>(std::find(around.begin(), around.end(), neighbour) - around.begin());
}

}  // namespace

/// Where a walk stands: at a vertex, or about to enter a triangle.
struct SheetWalk::State {
  Vec2 start;
  Vec2 target;
  std::vector<WalkStep> steps;
  Index vertex = no_index;    ///< lifted; no_index between vertices
  Index triangle = no_index;  ///< lifted, about to be entered …
  Index entry = 0;            ///< … across the edge opposite to this corner
  double along = 0;
  bool arrived = false;

  int side(const Vec2& point) const { return orientation(start, target, point); }

  /// For points on the line: not before the target.
  bool reaches_target(const Vec2& point) const {
    const Vec2 way = target - start;
    const Eigen::Index axis = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1;
    return way[axis] > 0 ? point[axis] >= target[axis] : point[axis] <= target[axis];
  }

  double fraction(const Vec2& point) const {
    const Vec2 way = target - start;
    return std::clamp((point - start).dot(way) / way.squaredNorm(), along, 1.0);
  }

  /// Where the line crosses the line through two points.
  double fraction(const Vec2& a, const Vec2& b) const {
    return std::clamp(cross(a - start, b - a) / cross(target - start, b - a), along, 1.0);
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

void SheetWalk::finish_step(State& state, Index triangle, double leave) const {
  state.steps.push_back({triangle, state.along, leave});
}

/// The triangle at a vertex whose angle the line enters, with the vertex's corner in it.
Index SheetWalk::find_sector(const State& state, Index vertex, Index& corner) const {
  const Index first = first_corner_[vertex];
  Index triangle = first / 3;
  corner = first % 3;
  do {
    const std::array<Index, 3>& corners = lifted_.triangles[triangle];
    const int right = state.side(points_[lifted_.planar_vertex[corners[next(corner)]]]);
    const int left = state.side(points_[lifted_.planar_vertex[corners[previous(corner)]]]);
    if (right <= 0 && left >= 0) return triangle;
    const Index following = lifted_.neighbours[triangle][next(corner)];
    if (following == no_index) break;
    corner = next(corner_across(lifted_, following, triangle));
    triangle = following;
  } while (triangle != first / 3);
  return no_index;
}

void SheetWalk::follow_edge(State& state, Index triangle, Index end_corner, Index other_corner) const {
  const Index end = lifted_.triangles[triangle][end_corner];
  const Vec2& point = points_[lifted_.planar_vertex[end]];
  state.arrived = state.reaches_target(point);
  const double leave = state.arrived ? 1 : state.fraction(point);
  finish_step(state, triangle, leave);
  const Index twin = lifted_.neighbours[triangle][other_corner];
  if (twin != no_index) finish_step(state, twin, leave);
  state.along = leave;
  state.vertex = end;
}

void SheetWalk::pass_vertex(State& state) const {
  Index corner = 0;
  const Index triangle = find_sector(state, state.vertex, corner);
  if (triangle == no_index) {
    throw Error(make_error(Category::Internal, "E_INTERNAL", "a chord leaves the region that it belongs to"));
  }
  const std::array<Index, 3>& corners = lifted_.triangles[triangle];
  const Vec2& right = points_[lifted_.planar_vertex[corners[next(corner)]]];
  const Vec2& left = points_[lifted_.planar_vertex[corners[previous(corner)]]];
  if (state.side(right) == 0) return follow_edge(state, triangle, next(corner), previous(corner));
  if (state.side(left) == 0) return follow_edge(state, triangle, previous(corner), next(corner));
  state.vertex = no_index;
  state.arrived = orientation(right, left, state.target) >= 0;
  const double leave = state.arrived ? 1 : state.fraction(right, left);
  finish_step(state, triangle, leave);
  state.along = leave;
  state.triangle = lifted_.neighbours[triangle][corner];
  state.entry = state.triangle == no_index ? 0 : corner_across(lifted_, state.triangle, triangle);
}

void SheetWalk::cross_triangle(State& state) const {
  const Index triangle = state.triangle;
  if (triangle == no_index) {
    throw Error(make_error(Category::Internal, "E_INTERNAL", "a chord leaves the region that it belongs to"));
  }
  const std::array<Index, 3>& corners = lifted_.triangles[triangle];
  const Vec2& apex = points_[lifted_.planar_vertex[corners[state.entry]]];
  // Seen along the walk: the entry edge's end on the left comes next after the apex.
  const Vec2& left = points_[lifted_.planar_vertex[corners[next(state.entry)]]];
  const Vec2& right = points_[lifted_.planar_vertex[corners[previous(state.entry)]]];
  state.arrived = orientation(right, apex, state.target) >= 0 && orientation(apex, left, state.target) >= 0;
  const int side = state.side(apex);
  double leave = 1;
  if (!state.arrived) {
    leave = side == 0 ? state.fraction(apex) : (side > 0 ? state.fraction(right, apex) : state.fraction(apex, left));
  }
  finish_step(state, triangle, leave);
  state.along = leave;
  if (side == 0) {
    state.vertex = corners[state.entry];
    return;
  }
  const Index exit = side > 0 ? next(state.entry) : previous(state.entry);
  state.triangle = lifted_.neighbours[triangle][exit];
  state.entry = state.triangle == no_index ? 0 : corner_across(lifted_, state.triangle, triangle);
}

std::vector<WalkStep> SheetWalk::walk(Index from, const Vec2& target) const {
  State state;
  state.start = points_[lifted_.planar_vertex[from]];
  state.target = target;
  state.vertex = from;
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
