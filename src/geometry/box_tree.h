// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"
#include "geometry/packed_box.h"

namespace croquis {

/// Finds which boxes overlap: a flat tree of eights over the boxes in Morton order of their middles. Built in linear
/// time. Boxes that overlap few others cost about as much as the tree is high.
class BoxTree {
 public:
  explicit BoxTree(std::span<const PackedBox> boxes);

  std::size_t leaf_count() const { return levels_.front().size(); }

  /// Calls visit(i, j) for pairs of boxes i != j that overlap, one of them in this leaf: over all leaves each pair
  /// once.
  template <typename Visit>
  void visit_pairs_of_leaf(std::size_t leaf, Visit&& visit) const {
    visit_leaves(levels_.size() - 1, 0, levels_.front()[leaf], leaf,
                 [&](std::size_t other) { join(leaf, *this, other, visit); });
  }

  /// Calls visit(i, j) for each box i in this leaf and each box j of the other tree that overlap.
  template <typename Visit>
  void visit_pairs_between(std::size_t leaf, const BoxTree& other, Visit&& visit) const {
    if (other.boxes_.empty()) return;
    other.visit_leaves(other.levels_.size() - 1, 0, levels_.front()[leaf], 0,
                       [&](std::size_t other_leaf) { join(leaf, other, other_leaf, visit); });
  }

 private:
  static constexpr std::size_t fan = 8;
  static constexpr std::size_t fan_bits = 3;

  std::size_t end_of(std::size_t leaf) const { return std::min(boxes_.size(), (leaf + 1) * fan); }

  /// Visits the leaves below a node that overlap the box, from leaf `first` on.
  template <typename Visit>
  void visit_leaves(std::size_t level, std::size_t node, const PackedBox& box, std::size_t first, Visit&& visit) const {
    if (!overlap(box, levels_[level][node])) return;
    if (level == 0) return visit(node);
    const std::size_t begin = std::max(node * fan, first >> (fan_bits * (level - 1)));
    const std::size_t end = std::min(levels_[level - 1].size(), (node + 1) * fan);
    for (std::size_t child = begin; child < end; ++child) visit_leaves(level - 1, child, box, first, visit);
  }

  /// Lists first and visits then: whether boxes overlap is nearly random, and a list needs no branches.
  template <typename Visit>
  void join(std::size_t leaf, const BoxTree& other, std::size_t other_leaf, Visit&& visit) const {
    const bool is_same = this == &other && leaf == other_leaf;
    const std::size_t end = other.end_of(other_leaf);
    std::array<std::array<Index, 2>, fan * fan> found;  // not initialised, that would cost more than the search
    std::size_t count = 0;
    for (std::size_t i = leaf * fan; i < end_of(leaf); ++i) {
      if (!overlap(boxes_[i], other.levels_.front()[other_leaf])) continue;
      for (std::size_t j = is_same ? i + 1 : other_leaf * fan; j < end; ++j) {
        found[count] = {items_[i], other.items_[j]};
        count += overlap(boxes_[i], other.boxes_[j]) ? 1U : 0U;
      }
    }
    for (std::size_t k = 0; k < count; ++k) visit(found[k][0], found[k][1]);
  }

  std::vector<Index> items_;                    ///< in Morton order
  std::vector<PackedBox> boxes_;                ///< of the items
  std::vector<std::vector<PackedBox>> levels_;  ///< around eights of the level before; the first around eights of boxes
};

}  // namespace croquis
