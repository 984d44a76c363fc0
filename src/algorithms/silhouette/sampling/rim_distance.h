// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/sampling/sheet_sampling.h"

namespace croquis::silhouette {

/// An edge of the region's boundary, the surface on its left.
struct RimEdge {
  Index begin = 0;  ///< lifted vertices
  Index end = 0;
  double radius = 0;     ///< of its rows, see row_radii
  double first_row = 0;  ///< depth of the first of them
};

/// How far every sampled place is from the rim of its own sheet; rims of other sheets above the same place don't count.
struct RimDistances {
  std::vector<RimEdge> edges;
  std::vector<Index> nearest;    ///< per lifted vertex: its edge; no_index further away than the reach
  std::vector<double> distance;  ///< per lifted vertex; 0 on the boundary, infinite further away than the reach
};

/// Carried from vertex to vertex inwards, so that it stays in the sheet: exact where the nearest edge is also the
/// nearest one of a neighbour, or next to it. O(M).
/// @param reach how far to go, as a part of the radius at the rim
RimDistances rim_distances(const SheetSampling& sheets, double reach);

/// How deep a place lies under a rim's edge.
double depth_below(const SheetSampling& sheets, const RimEdge& edge, Index vertex);

}  // namespace croquis::silhouette
