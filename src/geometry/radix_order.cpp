// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/radix_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace croquis {
namespace {

constexpr std::size_t digit_bits = 11;
constexpr std::size_t digit_values = std::size_t{1} << digit_bits;
constexpr std::size_t digit_count = (64 + digit_bits - 1) / digit_bits;

/// Below this many keys comparing is cheaper than counting digits.
constexpr std::size_t fewest_to_count = 1000;

struct Item {
  std::uint64_t key;
  Index place;
};

using Histogram = std::array<std::size_t, digit_values>;

std::size_t digit(std::uint64_t key, std::size_t number) {
  return static_cast<std::size_t>(key >> (number * digit_bits)) & (digit_values - 1);
}

std::vector<Histogram> count_digits(std::span<const std::uint64_t> keys) {
  std::vector<Histogram> counts(digit_count, Histogram{});
  for (const std::uint64_t key : keys) {
    for (std::size_t d = 0; d < digit_count; ++d) ++counts[d][digit(key, d)];
  }
  return counts;
}

/// Stable in one digit. @param places where each value begins; used up
void scatter(const std::vector<Item>& items, std::size_t number, Histogram& places, std::vector<Item>& sorted) {
  std::exclusive_scan(places.begin(), places.end(), places.begin(), std::size_t{0});
  for (const Item& item : items) sorted[places[digit(item.key, number)]++] = item;
}

}  // namespace

std::vector<Index> radix_order(std::span<const std::uint64_t> keys) {
  std::vector<Item> items(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) items[i] = {keys[i], static_cast<Index>(i)};
  if (keys.size() < fewest_to_count) {
    std::stable_sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.key < b.key; });
  } else {
    std::vector<Item> sorted(items.size());
    std::vector<Histogram> counts = count_digits(keys);
    for (std::size_t d = 0; d < digit_count; ++d) {
      if (counts[d][digit(keys.front(), d)] == keys.size()) continue;
      scatter(items, d, counts[d], sorted);
      items.swap(sorted);
    }
  }
  std::vector<Index> order(items.size());
  std::transform(items.begin(), items.end(), order.begin(), [](const Item& item) { return item.place; });
  return order;
}

}  // namespace croquis
