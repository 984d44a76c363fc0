// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bitset>
#include <span>
#include <vector>

#include "algorithms/silhouette/skeleton/immersion.h"

namespace croquis::silhouette {

/// A node of the axis before any is left out: the middle of an inner edge, or the centre of a triangle.
struct AxisNode {
  Vec2 position = Vec2::Zero();
  double radius = 0;
  Index triangle = no_index;
  Index corner = no_index;  ///< the edge opposite to this corner; no_index for the centre
  /// Ends of the chords that were absorbed into the cap or blob that this node stands for.
  std::vector<std::array<Index, 2>> absorbed = {};
};

struct AxisGraph {
  std::vector<AxisNode> nodes;
  std::vector<std::array<Index, 2>> edges;
  /// Per vertex of the immersed triangulation: the mean radius of the chords that end there, or of the chord or cap it
  /// was swallowed through.
  std::vector<double> vertex_radius;
};

/// The chordal axis without insignificant branches: a sleeve joins the middles of its two open edges, a junction its
/// centre with three of them, a blob is one node.
AxisGraph axis_graph(const ImmersedTriangulation& immersed, std::span<const Vec2> points);

/// Per triangle and corner, whether the edge opposite to it leads on along the axis: a triangle with none of them was
/// absorbed or is a blob, with one an end, with two a sleeve, with three a junction.
/// @param reach branches within so many half lengths of their foot's middle are insignificant, 1.02 for `axis_graph`
std::vector<std::bitset<3>> open_edges(const ImmersedTriangulation& immersed, std::span<const Vec2> points,
                                       double reach);

/// Distance that neighbours along a branch should keep: max(least, factor r).
struct NodeSpacing {
  double least = 0;     ///< sketch units
  double factor = 0.3;  ///< of the local radius
};

/// Leaves out nodes along branches so that neighbours are about that far apart; ends and junctions stay, and a loop
/// keeps at least three nodes, wherever it is begun. Joined nodes much nearer than that become one.
///
/// Every branch is cut evenly, so the result doesn't depend on the direction it is followed in, but for rounding.
AxisGraph decimate(const AxisGraph& graph, const NodeSpacing& spacing);

}  // namespace croquis::silhouette
