// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// Sorts a list, and leaves one of equal elements.
template <typename List>
void sort_unique(List& list) {
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// The place of an element in a sorted list, or of the first one behind where it would be.
template <typename List, typename Element>
Index place_in(const List& sorted, const Element& element) {
  return static_cast<Index>(std::ranges::lower_bound(sorted, element) - sorted.begin());
}

/// The elements of a list that is sorted by a key whose key is this one.
template <typename List, typename Key, typename KeyOf>
std::span<const typename List::value_type> with_key(const List& sorted, const Key& key, const KeyOf& key_of) {
  const auto first = std::ranges::lower_bound(sorted, key, {}, key_of);
  return {first, std::ranges::upper_bound(first, sorted.end(), key, {}, key_of)};
}

}  // namespace croquis::hole_filling
