// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// A constrained Delaunay triangulation of points in the plane.
struct PlanarTriangulation {
  std::vector<std::array<Index, 3>> triangles;    ///< #T by 3, counter-clockwise, indices into the points given
  std::vector<std::array<Index, 3>> neighbours;   ///< #T by 3, the triangle across the edge opposite to corner i, or
                                                  ///< no_index outside the convex hull
  std::vector<std::array<Index, 3>> constraints;  ///< #T by 3, index of the constraint that is that edge, or no_index
};

/// What kept a triangulation from being made: pairs of points at one place, or pairs of constraints that meet.
struct PlanarConflict {
  std::vector<std::pair<Index, Index>> coincident_points;
  std::vector<Index> blocked_constraints;  ///< that cross another one, run through a foreign point, or join
                                           ///< a point to itself

  bool empty() const { return coincident_points.empty() && blocked_constraints.empty(); }
};

struct PlanarTriangulationResult {
  PlanarTriangulation triangulation;  ///< empty when there is a conflict, and for fewer than 3 or collinear points
  PlanarConflict conflict;
};

/// Triangulates the convex hull of the points so that every constraint is an edge; exact predicates throughout.
///
/// Constraints may share end points and nothing else; what meets otherwise is reported as a conflict, never repaired.
/// @param points      #P by 2
/// @param constraints pairs of indices into points
/// O(n log n). The triangles come in an order that depends on the input alone.
PlanarTriangulationResult triangulate(std::span<const Vec2> points, std::span<const std::array<Index, 2>> constraints);

/// The triangles that an odd number of constraints separates from the outside, in their order: the inside of closed
/// loops, without that of loops within loops. Linear.
/// @param plane of constraints that are closed loops
std::vector<std::array<Index, 3>> triangles_inside(const PlanarTriangulation& plane);

}  // namespace croquis
