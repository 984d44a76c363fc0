// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/rim_triangulation.h"

namespace croquis::hole_filling {

/// The cheapest triangulation of one closed polygon by `triangle_cost`: weights W(i,k) = min over j of
/// W(i,j) + W(j,k) + cost(i,j,k), Barequet and Sharir 1995, section 3. n^3 / 6 costs.
/// @param order the polygon as points of `rims`; a point may come twice, where loops are bridged
/// @return triangles of points, or nothing when every triangulation has a triangle without area or a blocked edge
std::optional<std::vector<std::array<Index, 3>>> minimal_triangulation(const RimPolygon& rims,
                                                                       std::span<const Index> order,
                                                                       Progress& progress);

/// The same again and again, while more triangles are avoided: each time only what that changes is searched again.
class MinimalTriangulations {
 public:
  /// @param rims kept as a reference: `avoided` may grow between searches, nothing else may change
  /// @param order as for minimal_triangulation, three or more
  MinimalTriangulations(const RimPolygon& rims, std::vector<Index> order);
  ~MinimalTriangulations();

  /// @return what minimal_triangulation would
  std::optional<std::vector<std::array<Index, 3>>> next(Progress& progress);

 private:
  class Table;
  std::unique_ptr<Table> table_;
};

/// One closed polygon of all loops: each further loop is entered and left over the shortest bridge to what is joined
/// already, or where they share a vertex. Quadratic in the points.
std::vector<Index> bridged_order(const RimPolygon& rims);

}  // namespace croquis::hole_filling
