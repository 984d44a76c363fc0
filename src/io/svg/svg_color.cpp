// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg/svg_color.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "croquis/base/limits.h"
#include "io/svg/svg_shapes.h"
#include "io/text.h"

namespace croquis {
namespace {

/// Those of CSS that people use.
constexpr std::array<std::pair<std::string_view, const char*>, 40> colour_names{
    {{"red", "#FF0000"},       {"crimson", "#DC143C"},     {"firebrick", "#B22222"},  {"darkred", "#8B0000"},
     {"maroon", "#800000"},    {"blue", "#0000FF"},        {"navy", "#000080"},       {"mediumblue", "#0000CD"},
     {"royalblue", "#4169E1"}, {"dodgerblue", "#1E90FF"},  {"yellow", "#FFFF00"},     {"gold", "#FFD700"},
     {"orange", "#FFA500"},    {"darkorange", "#FF8C00"},  {"green", "#008000"},      {"lime", "#00FF00"},
     {"limegreen", "#32CD32"}, {"forestgreen", "#228B22"}, {"seagreen", "#2E8B57"},   {"darkgreen", "#006400"},
     {"purple", "#800080"},    {"indigo", "#4B0082"},      {"blueviolet", "#8A2BE2"}, {"darkviolet", "#9400D3"},
     {"white", "#FFFFFF"},     {"silver", "#C0C0C0"},      {"gray", "#808080"},       {"grey", "#808080"},
     {"black", "#000000"},     {"pink", "#FFC0CB"},        {"hotpink", "#FF69B4"},    {"salmon", "#FA8072"},
     {"brown", "#A52A2A"},     {"tan", "#D2B48C"},         {"beige", "#F5F5DC"},      {"khaki", "#F0E68C"},
     {"teal", "#008080"},      {"cyan", "#00FFFF"},        {"skyblue", "#87CEEB"},    {"magenta", "#FF00FF"}}};

std::optional<SvgColor> hexadecimal(std::string_view digits) {
  if (digits.size() != 3 && digits.size() != 6) return std::nullopt;
  const std::size_t width = digits.size() / 3;
  SvgColor rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view part = digits.substr(i * width, width);
    int value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value, 16);
    if (error != std::errc() || end != part.data() + part.size() || value < 0) return std::nullopt;
    rgb[i] = width == 1 ? 17 * value : value;
  }
  return rgb;
}

std::optional<SvgColor> functional(std::string_view numbers) {
  SvgScanner scanner(numbers);
  SvgColor rgb{};
  for (double& part : rgb) {
    scanner.skip_separators();
    const std::optional<double> value = scanner.number();
    if (!value || !is_usable_number(*value)) return std::nullopt;
    const bool percent = scanner.peek() == '%';
    if (percent) scanner.take();
    part = percent ? *value * 2.55 : *value;
  }
  return rgb;
}

}  // namespace

std::optional<SvgColor> svg_color(std::string_view text) {
  const std::string colour = lower_case(trimmed(text));
  if (colour.starts_with('#')) return hexadecimal(std::string_view(colour).substr(1));
  if (colour.starts_with("rgb(")) return functional(std::string_view(colour).substr(4));
  if (colour.starts_with("rgba(")) return functional(std::string_view(colour).substr(5));
  for (const auto& [name, hex] : colour_names) {
    if (colour == name) return hexadecimal(std::string_view(hex).substr(1));
  }
  return std::nullopt;
}

std::string hexadecimal_text(const SvgColor& color) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const double part : color) {
    const int level = static_cast<int>(std::lround(std::clamp(part, 0.0, 255.0)));
    text += digits[level / 16];
    text += digits[level % 16];
  }
  return text;
}

}  // namespace croquis
