// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace croquis {

/// Moves bit i of a number to bit 3 i, for Morton codes: three spread numbers, shifted by 0, 1 and 2, are one code, and
/// places with near codes are mostly near each other (Morton 1966).
/// @param bits below 2^21
constexpr std::uint64_t spread_by_three(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x1f00000000ffffU;
  bits = (bits | bits << 16) & 0x1f0000ff0000ffU;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fU;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3U;
  return (bits | bits << 2) & 0x1249249249249249U;
}

}  // namespace croquis
