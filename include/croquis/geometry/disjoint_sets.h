// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Union-find over 0 … count-1. The root of a set is its lowest element, so that numbering by roots does not depend on
/// the order of the unions.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

  Index root(Index element) {
    while (parent_[element] != element) {
      parent_[element] = parent_[parent_[element]];  // path halving
      element = parent_[element];
    }
    return element;
  }

  void unite(Index a, Index b) {
    if (parent_[a] == parent_[b]) return;
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent_[high] = low;
  }

  /// For each element the lowest one of its set; uses the sets up.
  std::vector<Index> take_roots() {
    for (Index& parent : parent_) parent = parent_[parent];  // a parent is lower, so it is a root by now
    return std::move(parent_);
  }

  /// The elements of each set, ascending; sets by their lowest.
  std::vector<std::vector<Index>> lists() {
    std::vector<std::vector<Index>> members(parent_.size());
    for (Index element = 0; element < parent_.size(); ++element) members[root(element)].push_back(element);
    std::erase_if(members, [](const auto& set) { return set.empty(); });
    return members;
  }

  /// Numbers the sets by their lowest elements and uses them up.
  /// @param numbers is given, for each element, the number of its set
  /// @return how many sets there are
  Index number(std::vector<Index>& numbers) {
    Index count = 0;
    for (Index element = 0; element < parent_.size(); ++element) {
      // A parent is lower than its child and so holds its number already.
      parent_[element] = parent_[element] == element ? count++ : parent_[parent_[element]];
    }
    numbers = std::move(parent_);
    return count;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace croquis
