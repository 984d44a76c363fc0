// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// Answers "is anything nearer than d?" for points and segments, in constant time where they are spread evenly.
///
/// Every item is entered in all cells within the grid's reach, so that a query visits one cell only.
class ProximityGrid {
 public:
  /// @param low,high corners of the box of all queries
  /// @param reach    largest distance that will be asked for, > 0
  ProximityGrid(const Vec2& low, const Vec2& high, double reach);

  void add(const Vec2& a, const Vec2& b);  ///< a segment
  void add(const Vec2& point) { add(point, point); }

  /// True when an item lies nearer to the place than the distance (at most the reach).
  bool any_within(const Vec2& place, double distance) const;

 private:
  struct Entry {
    Vec2 a, b;
    std::int64_t next;
  };

  std::int64_t column(double x) const;
  std::int64_t row(double y) const;

  Vec2 low_;
  double reach_;
  double cell_;
  std::int64_t columns_, rows_;
  std::vector<std::int64_t> first_;  ///< per cell, into entries_; -1 for none
  std::vector<Entry> entries_;
};

}  // namespace croquis::silhouette
