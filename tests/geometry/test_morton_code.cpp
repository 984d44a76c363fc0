// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/geometry/morton_code.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

TEST_CASE("bit i of a number goes to bit 3 i, and no other bit is set") {
  constexpr unsigned most_bits = 21;
  Random random(1);
  for (int run = 0; run < 1000; ++run) {
    const std::uint64_t number = random.bits() & ((1U << most_bits) - 1);
    std::uint64_t expected = 0;
    for (unsigned bit = 0; bit < most_bits; ++bit) expected |= (number >> bit & 1U) << (3 * bit);
    CHECK(spread_by_three(number) == expected);
  }
}
