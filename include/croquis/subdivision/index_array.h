// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::subdivision {

/// Memory for arrays that are written once and read often: large blocks ask the system for large pages, since half the
/// time of making a level goes into the first touch of small ones.
/// @throws std::bad_alloc
void* allocate_block(std::size_t bytes);
void free_block(void* block);

/// Leaves new elements unset where a vector would zero them: arrays of a level are written by one pass right after
/// they got their size, and touching their memory twice costs as much as computing it.
template <typename T>
struct UnsetAllocator {
  using value_type = T;

  UnsetAllocator() = default;
  template <typename U>
  UnsetAllocator(const UnsetAllocator<U>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_block(count * sizeof(T))); }
  void deallocate(T* block, std::size_t) { free_block(block); }

  template <typename U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <typename U, typename... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const UnsetAllocator&, const UnsetAllocator&) { return true; }
};

/// A vector of indices whose resize() leaves new elements unset.
using IndexArray = std::vector<Index, UnsetAllocator<Index>>;

}  // namespace croquis::subdivision
