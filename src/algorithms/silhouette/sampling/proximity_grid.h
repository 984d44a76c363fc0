// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {

/// Answers "is anything nearer than d?" for points and segments. Every item is entered in all cells within the grid's
/// reach, so that a query visits one cell only.
class ProximityGrid {
 public:
  /// @param reach largest distance that will be asked for, > 0
  explicit ProximityGrid(double reach) : reach_(reach) {}

  void add(const Vec2& point) { add(point, point); }
  void add(const Vec2& a, const Vec2& b) {  ///< a segment
    const Vec2 around = Vec2::Constant(reach_);
    const Cell low = cell_of(a.cwiseMin(b) - around), high = cell_of(a.cwiseMax(b) + around);
    for (long x = low.first; x <= high.first; ++x) {
      for (long y = low.second; y <= high.second; ++y) cells_[{x, y}].push_back({a, b});
    }
  }

  /// True when an item lies nearer to the place than the distance (at most the reach).
  bool any_within(const Vec2& place, double distance) const {
    const auto cell = cells_.find(cell_of(place));
    return cell != cells_.end() && std::any_of(cell->second.begin(), cell->second.end(), [&](const auto& item) {
             return (nearest_on_segment(place, item[0], item[1]) - place).squaredNorm() < distance * distance;
           });
  }

 private:
  using Cell = std::pair<long, long>;

  Cell cell_of(const Vec2& place) const {
    return {std::lround(place.x() / (2 * reach_)), std::lround(place.y() / (2 * reach_))};
  }

  double reach_;
  std::map<Cell, std::vector<std::array<Vec2, 2>>> cells_;
};

}  // namespace croquis::silhouette
