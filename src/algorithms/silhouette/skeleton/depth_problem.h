// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algorithms/silhouette/skeleton/collision_rows.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/solver/least_squares.h"

namespace croquis::silhouette {

/// Nodes that edges and collision rows connect, directly or not: they can be solved without the others.
struct DepthPart {
  std::vector<Index> nodes;  ///< ascending
  std::vector<Index> edges;  ///< indices into Skeleton::edges
  std::vector<Index> rows;   ///< indices into the collision rows
};

/// In the order of their first nodes.
std::vector<DepthPart> depth_parts(const Skeleton& skeleton, std::span<const CollisionRow> rows);

/// Everything of a part's least-squares problem but its collision rows. Unknowns (z/L, gx, gy) per node of the part:
/// all lengths are measured in L, so that a drawing and its enlargement give the same numbers.
/// @param rest per object the height that it is pulled to, sketch units; empty: the sketch plane
LeastSquaresProblem depth_problem(const Skeleton& skeleton, const DepthPart& part, const DepthSettings& settings,
                                  std::span<const double> rest = {});

/// Puts those collision rows into a part's problem, in their order.
void set_collision_rows(const Skeleton& skeleton, const DepthPart& part, std::span<const CollisionRow> rows,
                        LeastSquaresProblem& problem);

}  // namespace croquis::silhouette
