// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/box_tree.h"

#include <cstdint>

#include "croquis/geometry/morton_order.h"

namespace croquis {
namespace {

/// Of each coordinate of a middle; more would not change which boxes share a leaf in meshes of millions of faces.
constexpr unsigned morton_bits = 11;

std::uint64_t morton_key(const PackedBox& box) {
  const PackedPlace middles = box.low + box.high;  // twice the middles: they fill the guard bits
  std::uint64_t key = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const std::uint64_t middle = middles >> (axis * packed_stride) & ((std::uint64_t{1} << packed_stride) - 1);
    key |= spread_by_three(middle >> (packed_stride - morton_bits)) << axis;
  }
  return key >> 1;  // 32 bits are faster to sort than 33
}

std::vector<PackedBox> level_above(const std::vector<PackedBox>& boxes, std::size_t fan) {
  std::vector<PackedBox> above;
  above.reserve((boxes.size() + fan - 1) / fan);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (i % fan == 0)
      above.push_back(boxes[i]);
    else
      above.back() = united(above.back(), boxes[i]);
  }
  return above;
}

}  // namespace

BoxTree::BoxTree(std::span<const PackedBox> boxes) {
  std::vector<std::uint64_t> keys(boxes.size());
  std::transform(boxes.begin(), boxes.end(), keys.begin(), morton_key);
  items_ = radix_order(keys);
  boxes_.reserve(boxes.size());
  for (const Index item : items_) boxes_.push_back(boxes[item]);
  levels_.push_back(level_above(boxes_, fan));
  while (levels_.back().size() > 1) levels_.push_back(level_above(levels_.back(), fan));
}

}  // namespace croquis
