// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// Numbers vertices of a large mesh 0, 1, … in the order in which they are met: what a search around one hole looks at
/// can then lie in arrays. Open addressing; nothing depends on where entries come to lie.
class VertexNumbers {
 public:
  VertexNumbers() : slots_(first_slots) {}

  std::size_t size() const { return count_; }

  /// The vertex' number, and whether it is a new one.
  std::pair<Index, bool> number(Index vertex) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[find(vertex)];
    const bool is_new = slot.vertex == no_index;
    if (is_new) slot = {vertex, static_cast<Index>(count_++)};
    return {slot.number, is_new};
  }

  /// no_index for one that hasn't been met.
  Index known_number(Index vertex) const { return slots_[find(vertex)].number; }

 private:
  struct Slot {
    Index vertex = no_index;
    Index number = no_index;
  };
  static constexpr std::size_t first_slots = 1024;  // a power of two, as ever after

  std::size_t find(Index vertex) const {
    std::size_t place = vertex * std::size_t{0x9E3779B97F4A7C15} >> 32;  // neighbours in the mesh go far apart
    for (;; ++place) {
      const Index there = slots_[place & (slots_.size() - 1)].vertex;
      if (there == vertex || there == no_index) return place & (slots_.size() - 1);
    }
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.vertex != no_index) slots_[find(slot.vertex)] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace croquis::hole_filling
