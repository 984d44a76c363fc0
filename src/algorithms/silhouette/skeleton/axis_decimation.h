// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/skeleton/axis_graph.h"

namespace croquis::silhouette {

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
