// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/perspective/sheet_units.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "croquis/base/limits.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 4> units{std::pair{"mm", 0.001}, std::pair{"cm", 0.01},
                                                                   std::pair{"m", 1.0}, std::pair{"in", 0.0254}};

/// Letters at the end of a text, and the text before them.
std::pair<std::string_view, std::string_view> number_and_unit(std::string_view text) {
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  std::size_t length = text.size();
  while (length > 0 && std::isalpha(static_cast<unsigned char>(text[length - 1])) != 0) --length;
  return {text.substr(0, length), text.substr(length)};
}

/// How many of the drawing's units one typed unit has; nothing where that isn't known.
std::optional<double> units_in(std::string_view typed, std::string_view unit) {
  if (typed.empty()) return 1;
  if (typed == "inch") typed = "in";
  const double from = metres_of_unit(typed), to = metres_of_unit(unit);
  return from > 0 && to > 0 ? std::optional(from / to) : std::nullopt;
}

std::optional<double> read_usable(std::string text) {
  std::ranges::replace(text, ',', '.');
  return usable_number(text);
}

}  // namespace

const std::vector<std::string>& length_units() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> made;
    for (const auto& [name, metres] : units) made.emplace_back(name);
    return made;
  }();
  return names;
}

double metres_of_unit(std::string_view unit) {
  const auto* const found = std::ranges::find(units, unit, &std::pair<std::string_view, double>::first);
  return found == units.end() ? 0 : found->second;
}

std::optional<double> read_length(std::string_view text, std::string_view unit) {
  const auto [numbers, typed] = number_and_unit(text);
  const std::vector<std::string_view> parts = text_parts(numbers, " ");
  const auto scale = units_in(typed, unit);
  if (parts.size() != 1 || !scale) return std::nullopt;
  const auto number = read_usable(std::string(parts[0]));
  return number && *number > 0 ? std::optional(*number * *scale) : std::nullopt;
}

/// Commas separate where there are blanks or semicolons beside them, or two of them and nothing else.
std::optional<Vec3> read_point(std::string_view text, std::string_view unit) {
  const auto [numbers, typed] = number_and_unit(text);
  std::vector<std::string_view> parts = text_parts(numbers, " ;");
  if (parts.size() == 1) parts = text_parts(numbers, ",");
  const auto scale = units_in(typed, unit);
  if (parts.size() != 3 || !scale) return std::nullopt;
  Vec3 point;
  for (int i = 0; i < 3; ++i) {
    std::string_view part = parts[static_cast<std::size_t>(i)];
    if (part.ends_with(',')) part.remove_suffix(1);
    const auto number = read_usable(std::string(part));
    if (!number) return std::nullopt;
    point[i] = *number * *scale;
  }
  return point;
}

}  // namespace croquis
