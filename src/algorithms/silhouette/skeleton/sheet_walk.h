// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algorithms/silhouette/skeleton/immersion.h"

namespace croquis::silhouette {

/// A stretch of a straight walk inside one lifted triangle, or along one of its edges.
struct WalkStep {
  Index triangle = no_index;  ///< lifted
  double enter = 0;           ///< 0..1 along the walk
  double leave = 0;
};

/// Walks straight lines through the immersed region, always in the sheet it started in.
///
/// Point location in the plane couldn't distinguish the layers. Every turn is decided by exact orientation tests, so
/// lines through vertices and along edges are no special case.
class SheetWalk {
 public:
  /// The arguments are kept by reference. O(M).
  SheetWalk(std::span<const Vec2> points, const LiftedTriangulation& lifted);

  /// From a lifted vertex straight to a place in the plane. Along an edge the triangles on both of its sides are steps.
  /// @param target reached within the region; different from the vertex's own place
  /// @throws Error (E_INTERNAL) when the line leaves the region before
  std::vector<WalkStep> walk(Index from, const Vec2& target) const;

 private:
  struct State;
  const Vec2& point(Index vertex) const { return points_[lifted_.planar_vertex[vertex]]; }
  void pass_vertex(State& state) const;
  void cross_triangle(State& state) const;
  void enter_beyond(State& state, Index corner) const;

  std::span<const Vec2> points_;
  const LiftedTriangulation& lifted_;
  std::vector<Index> first_corner_;  ///< per lifted vertex: the corner (3 triangle + i) where its fan begins
};

}  // namespace croquis::silhouette
