// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace croquis {

/// Three integers below 2^20 in one word, each with a guard bit above it: all three are compared at once.
using PackedPlace = std::uint64_t;

inline constexpr unsigned packed_bits = 20;
inline constexpr unsigned packed_stride = packed_bits + 1;
inline constexpr PackedPlace packed_guards = (PackedPlace{1} << packed_bits) |
                                             (PackedPlace{1} << (packed_bits + packed_stride)) |
                                             (PackedPlace{1} << (packed_bits + 2 * packed_stride));

inline PackedPlace packed(std::uint64_t value, std::size_t axis) { return value << (axis * packed_stride); }

/// The guards of the axes along which a is at or above b: elsewhere the difference has taken them.
inline PackedPlace at_or_above(PackedPlace a, PackedPlace b) { return ((a | packed_guards) - b) & packed_guards; }

struct PackedBox {
  PackedPlace low = 0;
  PackedPlace high = 0;  ///< inside, too
};

inline bool overlap(const PackedBox& a, const PackedBox& b) {
  return (at_or_above(a.high, b.low) & at_or_above(b.high, a.low)) == packed_guards;
}

/// The smallest box around a box and a place.
inline PackedBox extended(const PackedBox& box, PackedPlace place) {
  const auto choose = [](PackedPlace guards, PackedPlace set, PackedPlace clear) {
    const PackedPlace mask = guards - (guards >> packed_bits);  // all bits below each guard that is set
    return (set & mask) | (clear & ~mask & ~packed_guards);
  };
  return {choose(at_or_above(place, box.low), box.low, place), choose(at_or_above(place, box.high), place, box.high)};
}

inline PackedBox united(const PackedBox& a, const PackedBox& b) { return extended(extended(a, b.low), b.high); }

}  // namespace croquis
