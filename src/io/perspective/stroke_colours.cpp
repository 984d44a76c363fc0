// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "croquis/base/limits.h"
#include "croquis/io/perspective_drawing_file.h"
#include "io/svg/svg_shapes.h"
#include "io/text.h"

namespace croquis {
namespace {

using Rgb = std::array<double, 3>;  // 0..255

constexpr std::array<const char*, 7> default_colours{"#F28C00", "#1F9D3A", "#8A2BE2", "#1F4FD8",
                                                     "#D81F2A", "#E0B400", "#808080"};

/// Those of CSS that people use for lines.
constexpr std::array<std::pair<std::string_view, const char*>, 24> colour_names{
    {{"red", "#FF0000"},       {"crimson", "#DC143C"},     {"firebrick", "#B22222"},  {"darkred", "#8B0000"},
     {"maroon", "#800000"},    {"blue", "#0000FF"},        {"navy", "#000080"},       {"mediumblue", "#0000CD"},
     {"royalblue", "#4169E1"}, {"dodgerblue", "#1E90FF"},  {"yellow", "#FFFF00"},     {"gold", "#FFD700"},
     {"orange", "#FFA500"},    {"darkorange", "#FF8C00"},  {"green", "#008000"},      {"lime", "#00FF00"},
     {"limegreen", "#32CD32"}, {"forestgreen", "#228B22"}, {"seagreen", "#2E8B57"},   {"darkgreen", "#006400"},
     {"purple", "#800080"},    {"indigo", "#4B0082"},      {"blueviolet", "#8A2BE2"}, {"darkviolet", "#9400D3"}}};

/// Hues of a group in degrees. Between red, orange and yellow, and between blue and purple, the nearer one is meant.
struct HueRange {
  double from, to;
  StrokeGroup group;
};

constexpr std::array<HueRange, 7> hue_ranges{{{210, 256, StrokeGroup::NormalX},
                                              {345, 360, StrokeGroup::NormalY},
                                              {0, 17.5, StrokeGroup::NormalY},
                                              {17.5, 39, StrokeGroup::ParallelX},
                                              {39, 62, StrokeGroup::NormalZ},
                                              {90, 165, StrokeGroup::ParallelY},
                                              {256, 300.5, StrokeGroup::ParallelZ}}};

std::optional<Rgb> hexadecimal(std::string_view digits) {
  if (digits.size() != 3 && digits.size() != 6) return std::nullopt;
  const std::size_t width = digits.size() / 3;
  Rgb rgb{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view part = digits.substr(i * width, width);
    int value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value, 16);
    if (error != std::errc() || end != part.data() + part.size() || value < 0) return std::nullopt;
    rgb[i] = width == 1 ? 17 * value : value;
  }
  return rgb;
}

std::optional<Rgb> functional(std::string_view numbers) {
  SvgScanner scanner(numbers);
  Rgb rgb{};
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

std::optional<Rgb> rgb_of(std::string_view text) {
  const std::string colour = lower_case(trimmed(text));
  if (colour.starts_with('#')) return hexadecimal(std::string_view(colour).substr(1));
  if (colour.starts_with("rgb(")) return functional(std::string_view(colour).substr(4));
  if (colour.starts_with("rgba(")) return functional(std::string_view(colour).substr(5));
  for (const auto& [name, hex] : colour_names) {
    if (colour == name) return hexadecimal(std::string_view(hex).substr(1));
  }
  return std::nullopt;
}

/// HSV, degrees; nothing where the colour is too grey.
std::optional<double> hue_of(const Rgb& rgb) {
  const auto [low, high] = std::minmax_element(rgb.begin(), rgb.end());
  const double chroma = *high - *low;
  if (!(chroma > 0.25 * *high)) return std::nullopt;
  double sixths = 0;
  switch (high - rgb.begin()) {
    case 0: sixths = (rgb[1] - rgb[2]) / chroma; break;
    case 1: sixths = 2 + (rgb[2] - rgb[0]) / chroma; break;
    default: sixths = 4 + (rgb[0] - rgb[1]) / chroma;
  }
  return sixths < 0 ? 60 * sixths + 360 : 60 * sixths;
}

}  // namespace

StrokeGroup group_of_colour(std::string_view colour) {
  const std::optional<Rgb> rgb = rgb_of(colour);
  const std::optional<double> hue = rgb ? hue_of(*rgb) : std::nullopt;
  if (!hue) return StrokeGroup::Unknown;
  for (const HueRange& range : hue_ranges) {
    if (*hue >= range.from && *hue <= range.to) return range.group;
  }
  return StrokeGroup::Unknown;
}

std::string colour_of_group(StrokeGroup group) { return default_colours[static_cast<std::size_t>(group)]; }

}  // namespace croquis
