// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/geometry/morton_order.h"
#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

using Box = Eigen::AlignedBox3d;

/// The box around places.
/// @param place of an item
template <typename Items, typename Place>
Box box_of(const Items& items, const Place& place) {
  Box box;
  for (const auto& item : items) box.extend(place(item));
  return box;
}

/// Finds which of many boxes meet one: a tree of eights over the boxes in Morton order of their middles. Linear to
/// make, thread-safe to ask.
/// @tparam BoxOf gives the box of an item; boxes themselves aren't kept
template <typename BoxOf>
class BoxSearch {
 public:
  BoxSearch(std::size_t count, BoxOf box_of) : box_of_(std::move(box_of)) {
    Box bounds;
    for (Index item = 0; item < count; ++item) bounds.extend(box_of_(item));
    std::vector<std::uint64_t> keys;
    for (Index item = 0; item < count; ++item) keys.push_back(morton_key(box_of_(item).center(), bounds));
    order_ = radix_order(keys);
    levels_.emplace_back((count + fan - 1) / fan);
    for (std::size_t i = 0; i < count; ++i) levels_[0][i / fan].extend(box_of_(order_[i]));
    while (levels_.back().size() > 1) {
      std::vector<Box> above((levels_.back().size() + fan - 1) / fan);
      for (std::size_t i = 0; i < levels_.back().size(); ++i) above[i / fan].extend(levels_.back()[i]);
      levels_.push_back(std::move(above));
    }
  }

  /// Calls visit(item) for every item whose box meets the box. @return how many boxes were looked at
  template <typename Visit>
  std::size_t visit(const Box& box, Visit&& visit) const {
    return order_.empty() ? 0 : descend(levels_.size() - 1, 0, box, visit);
  }

 private:
  static constexpr std::size_t fan = 8;  ///< boxes in one of the level above

  /// Bits of three coordinates in turn, ten of each: near places mostly have near keys.
  static std::uint64_t morton_key(const Vec3& place, const Box& bounds) {
    std::uint64_t key = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double size = bounds.sizes()[axis];
      const double share = size > 0 ? (place[axis] - bounds.min()[axis]) / size : 0;
      const auto cell = static_cast<std::uint32_t>(std::clamp(share * 1024, 0.0, 1023.0));
      key |= spread_by_three(cell) << axis;
    }
    return key;
  }

  template <typename Visit>
  std::size_t descend(std::size_t level, std::size_t node, const Box& box, Visit& visit) const {
    if (!levels_[level][node].intersects(box)) return 1;
    std::size_t looked_at = 1;
    const std::size_t end = std::min((node + 1) * fan, level == 0 ? order_.size() : levels_[level - 1].size());
    for (std::size_t child = node * fan; child < end; ++child) {
      if (level > 0) {
        looked_at += descend(level - 1, child, box, visit);
        continue;
      }
      ++looked_at;
      if (box_of_(order_[child]).intersects(box)) visit(order_[child]);
    }
    return looked_at;
  }

  BoxOf box_of_;
  std::vector<Index> order_;              ///< items, neighbours mostly behind one another
  std::vector<std::vector<Box>> levels_;  ///< around eights of items, of the level before, up to one
};

}  // namespace croquis::hole_filling
