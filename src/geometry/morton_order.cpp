// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/morton_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace croquis {
namespace {

constexpr std::size_t digit_bits = 11;
constexpr std::size_t digit_values = std::size_t{1} << digit_bits;

/// Below this many keys comparing is cheaper than counting digits.
constexpr std::size_t fewest_to_count = 1000;

struct Item {
  std::uint64_t key;
  Index place;
};

/// The same for keys of 32 bits, in half the memory.
struct ShortItem {
  std::uint32_t key;
  Index place;
};

using Histogram = std::array<std::uint32_t, digit_values>;

std::size_t digit(std::uint64_t key, std::size_t number) {
  return static_cast<std::size_t>(key >> (number * digit_bits)) & (digit_values - 1);
}

/// @param digits how many are looked at
std::vector<Histogram> count_digits(std::span<const std::uint64_t> keys, std::size_t digits) {
  std::vector<Histogram> counts(digits, Histogram{});
  for (const std::uint64_t key : keys) {
    for (std::size_t d = 0; d < digits; ++d) ++counts[d][digit(key, d)];
  }
  return counts;
}

/// Stable in one digit. @param places where each value begins; used up
template <typename Item>
void scatter(const std::vector<Item>& items, std::size_t number, Histogram& places, std::vector<Item>& sorted) {
  std::exclusive_scan(places.begin(), places.end(), places.begin(), std::uint32_t{0});
  for (const Item& item : items) sorted[places[digit(item.key, number)]++] = item;
}

template <typename Item>
std::vector<Index> order_by(std::span<const std::uint64_t> keys) {
  std::vector<Item> items(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
    items[i] = {static_cast<decltype(Item::key)>(keys[i]), static_cast<Index>(i)};
  if (keys.size() < fewest_to_count) {
    std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.key < b.key; });
  } else {
    constexpr std::size_t digits = (8 * sizeof(Item::key) + digit_bits - 1) / digit_bits;
    std::vector<Item> sorted(items.size());
    std::vector<Histogram> counts = count_digits(keys, digits);
    for (std::size_t d = 0; d < digits; ++d) {
      if (counts[d][digit(keys.front(), d)] == keys.size()) continue;
      scatter(items, d, counts[d], sorted);
      items.swap(sorted);
    }
  }
  std::vector<Index> order(items.size());
  std::transform(items.begin(), items.end(), order.begin(), [](const Item& item) { return item.place; });
  return order;
}

}  // namespace

std::vector<Index> radix_order(std::span<const std::uint64_t> keys) {
  const bool are_short = std::all_of(keys.begin(), keys.end(), [](std::uint64_t key) { return key >> 32 == 0; });
  return are_short ? order_by<ShortItem>(keys) : order_by<Item>(keys);
}

}  // namespace croquis
