// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/morton_order.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

TEST_CASE("keys of any size and number come in the order of a stable sort") {
  for (const std::size_t count : {0U, 1U, 2U, 999U, 1000U, 5000U}) {
    for (const unsigned shift : {0U, 7U, 31U, 52U, 63U}) {
      Random random(count + shift);
      std::vector<std::uint64_t> keys(count);
      for (std::uint64_t& key : keys) key = std::uint64_t{random.below(1000)} << shift;
      if (count > 2) keys[count / 2] = std::numeric_limits<std::uint64_t>::max();
      std::vector<Index> expected(count);
      std::iota(expected.begin(), expected.end(), Index{0});
      std::stable_sort(expected.begin(), expected.end(), [&](Index a, Index b) { return keys[a] < keys[b]; });
      CHECK(radix_order(keys) == expected);
    }
  }
}

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
