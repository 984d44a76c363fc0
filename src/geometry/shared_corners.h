// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "croquis/geometry/vector.h"

namespace croquis {

/// The corners of two triangles in an order that brings those with a common vertex to the same places at the front.
struct SharedCorners {
  std::uint8_t count = 0;
  std::array<std::uint8_t, 3> first = {0, 1, 2};
  std::array<std::uint8_t, 3> second = {0, 1, 2};
};

/// @param equal bit 3 i + j: corner i of the first is corner j of the second
constexpr SharedCorners arrange_shared(std::size_t equal) {
  SharedCorners result;
  const auto swap = [](std::uint8_t& a, std::uint8_t& b) {
    const std::uint8_t old = a;
    a = b;
    b = old;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = result.count; j < 3; ++j) {
      if ((equal >> (3 * i + result.second[j]) & 1) == 0) continue;
      swap(result.second[j], result.second[result.count]);
      swap(result.first[i], result.first[result.count]);
      ++result.count;
      break;
    }
  }
  return result;
}

/// One entry per pattern of equal corners: looked up instead of computed, since branches on the patterns can't be
/// predicted.
inline constexpr std::array<SharedCorners, 512> shared_corner_table = [] {
  std::array<SharedCorners, 512> table;
  for (std::size_t equal = 0; equal < table.size(); ++equal) table[equal] = arrange_shared(equal);
  return table;
}();

inline const SharedCorners& shared_corners(const std::array<Index, 3>& u, const std::array<Index, 3>& v) {
  std::size_t equal = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) equal |= std::size_t{u[i] == v[j]} << (3 * i + j);
  }
  return shared_corner_table[equal];
}

}  // namespace croquis
