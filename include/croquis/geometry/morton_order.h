// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

/// Orders in which places that follow one another are mostly near each other (Morton 1966).
namespace croquis {

/// Moves bit i of a number to bit 3 i: three spread numbers, shifted by 0, 1 and 2, are one Morton code.
/// @param bits below 2^21
constexpr std::uint64_t spread_by_three(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x1f00000000ffffU;
  bits = (bits | bits << 16) & 0x1f0000ff0000ffU;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fU;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3U;
  return (bits | bits << 2) & 0x1249249249249249U;
}

/// The places of the keys in ascending order, equal keys as they come. Linear: one pass per digit of 11 bits, sparing
/// those in which all keys agree, as the low ones of coordinates that were stored in single precision.
std::vector<Index> radix_order(std::span<const std::uint64_t> keys);

}  // namespace croquis
