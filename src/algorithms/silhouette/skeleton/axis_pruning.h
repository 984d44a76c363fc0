// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/silhouette/skeleton/immersed_triangulation.h"

namespace croquis::silhouette {

/// Which triangles of the immersed region carry the axis, and which were absorbed by their neighbours.
struct AxisPruning {
  /// Per triangle: the corner opposite to the edge it was absorbed through; no_index for triangles that carry the axis.
  std::vector<Index> exit;
  /// Per triangle: bit i is set when the edge opposite to corner i leads on along the axis.
  std::vector<std::uint8_t> open_edges;

  int open_count(Index triangle) const;
  bool is_open(Index triangle, Index corner) const { return (open_edges[triangle] >> corner & 1) != 0; }
};

/// Absorbs insignificant branches (Igarashi, Matsuoka, Tanaka 1999, section 5.1, extended past junctions): a triangle
/// with one open edge goes if all contour points swallowed so far lie within 1.02 times the half length of that edge
/// from its midpoint; then its neighbour is next. What is left doesn't depend on the order, except that of a blob that
/// is absorbed altogether an arbitrary triangle, without open edges, remains.
AxisPruning prune_axis(const ImmersedTriangulation& immersed, std::span<const Vec2> points);

}  // namespace croquis::silhouette
