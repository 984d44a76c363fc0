// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/index_list.h"

#include <optional>

#include "croquis/base/text.h"

namespace croquis {
namespace {

/// More elements than any mesh has that fits into memory; a longer range is a typing error.
constexpr std::uint32_t longest_range = 10000000;

std::optional<std::uint32_t> parse_index(std::string_view word) {
  std::uint32_t number = 0;
  return read_number(word, number) ? std::optional(number) : std::nullopt;
}

}  // namespace

bool append_indices(std::string_view word, std::vector<std::uint32_t>& numbers) {
  const std::size_t dash = word.find('-');
  const auto first = parse_index(word.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parse_index(word.substr(dash + 1));
  if (!first || !last || *last < *first || *last - *first >= longest_range) return false;
  for (std::uint32_t number = *first; number < *last; ++number) numbers.push_back(number);
  numbers.push_back(*last);
  return true;
}

std::string index_list_text(const std::vector<std::uint32_t>& numbers, char separator) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (!text.empty()) text += separator;
    text += std::to_string(numbers[i]);
    if (last > i) text += '-' + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace croquis
