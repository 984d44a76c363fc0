// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algorithms/silhouette/skeleton/collision_rows.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/solver/least_squares.h"

/// The depth problem: an edge from p_i to p_k carries a patch S = a x^2 + b x + c y^2 + d y + e x y + f through the
/// heights and gradients of its ends.
namespace croquis::silhouette {

/// A linear row of one skeleton edge: the coefficients of (z_i, gx_i, gy_i, z_k, gx_k, gy_k).
using EdgeRow = std::array<double, 6>;

/// A patch through both ends exists: [2 (z_k - z_i) - D.(g_i + g_k)] / l = 0, D = p_k - p_i, l = |D|.
///
/// The left null vector of the 6 by 6 interpolation matrix. Cordier, Seo, Cho 2006, section 4.4.2 print it divided by
/// y_i - y_k, which fails on horizontal edges.
/// @param along D, not zero
EdgeRow continuity_row(const Vec2& along);

/// Thin-plate energy of the patch over an area L l, least over the one coefficient that the ends leave free (curl
/// across the edge): the squares of the two rows, for D_f = 2.
/// Cordier, Seo, Cho 2006, section 4.4.3, in closed form:
/// E = L/l [(1 - nu^2) (t.(g_k - g_i))^2 + 2 (1 - nu) (m.(g_k - g_i))^2], t = D/l, m = t turned left.
/// The area L l in place of the paper's l^2 makes the energy independent of the number of nodes.
/// @param along D, not zero
/// @param scale L
/// @param poisson nu, 0..0.5
std::array<EdgeRow, 2> curvature_rows(const Vec2& along, double scale, double poisson = 0.5);

/// Nodes that edges and collision rows connect, directly or not: they can be solved without the others.
struct DepthPart {
  std::vector<Index> nodes;  ///< ascending
  std::vector<Index> edges;  ///< indices into Skeleton::edges
  std::vector<Index> rows;   ///< indices into the collision rows

  /// The place of a node among its nodes.
  Index local(Index node) const;
};

/// In the order of their first nodes.
std::vector<DepthPart> depth_parts(const Skeleton& skeleton, std::span<const CollisionRow> rows);

/// Everything of a part's least-squares problem but its collision rows; objects are pulled to Skeleton::rest, or to the
/// sketch plane. Unknowns (z/L, gx, gy) per node of the part: all lengths are measured in L, so that a drawing and its
/// enlargement give the same numbers.
LeastSquaresProblem depth_problem(const Skeleton& skeleton, const DepthPart& part, const DepthSettings& settings);

/// Puts those collision rows into a part's problem, in their order.
void set_collision_rows(const Skeleton& skeleton, const DepthPart& part, std::span<const CollisionRow> rows,
                        LeastSquaresProblem& problem);

}  // namespace croquis::silhouette
