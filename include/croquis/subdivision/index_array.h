// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::subdivision {

/// Leaves new elements unset where a vector would zero them: arrays of a level are written by one pass right after
/// they got their size, and touching their memory twice costs as much as computing it.
template <typename T>
struct UnsetAllocator : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };

  UnsetAllocator() = default;
  template <typename U>
  UnsetAllocator(const UnsetAllocator<U>&) {}

  template <typename U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <typename U, typename... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

/// A vector of indices whose resize() leaves new elements unset.
using IndexArray = std::vector<Index, UnsetAllocator<Index>>;

}  // namespace croquis::subdivision
