// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/perspective/perspective_strokes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "croquis/base/limits.h"
#include "croquis/io/perspective_drawing_file.h"
#include "io/text.h"

namespace croquis {
namespace {

std::vector<PictureCubic> cubics_of_arc(const SvgSegment& arc, const Vec2& from) {
  constexpr double quarter = std::numbers::pi / 2;
  if (!std::isfinite(arc.sweep)) return {straight_piece(from, arc.end)};
  const auto count = static_cast<int>(std::clamp(std::ceil(std::abs(arc.sweep) / quarter - 1e-9), 1.0, 8.0));
  const double step = arc.sweep / count, handle = 4.0 / 3 * std::tan(step / 4);
  const auto place = [&](double angle) { return Vec2(arc.centre + std::cos(angle) * arc.a + std::sin(angle) * arc.b); };
  const auto along = [&](double angle) { return Vec2(handle * (std::cos(angle) * arc.b - std::sin(angle) * arc.a)); };
  std::vector<PictureCubic> cubics;
  Vec2 start = from;
  for (int i = 0; i < count; ++i) {
    const double begin = arc.angle + i * step, end = begin + step;
    const Vec2 last = i + 1 == count ? arc.end : place(end);
    cubics.push_back({start, start + along(begin), last - along(end), last});
    start = last;
  }
  return cubics;
}

bool is_nearly_straight(const PerspectiveStroke& stroke, double tolerance) {
  const Vec2 chord = stroke.end() - stroke.start();
  const double length = chord.norm();
  if (!(length > tolerance)) return false;
  return std::ranges::all_of(stroke.pieces, [&](const PictureCubic& piece) {
    return std::ranges::all_of(piece, [&](const Vec2& point) {
      const double along = (point - stroke.start()).dot(chord) / length;
      return std::abs(cross(chord, point - stroke.start())) <= tolerance * length && along >= -tolerance &&
             along <= length + tolerance;
    });
  });
}

}  // namespace

PictureCubic straight_piece(const Vec2& from, const Vec2& to) {
  const Vec2 step = (to - from) / 3;
  return {from, from + step, to - step, to};
}

std::vector<PictureCubic> cubics_of(const SvgSegment& segment, const Vec2& from) {
  switch (segment.kind) {
    case SvgSegment::Kind::Line: return {straight_piece(from, segment.end)};
    case SvgSegment::Kind::Cubic: return {{from, segment.a, segment.b, segment.end}};
    case SvgSegment::Kind::Arc: break;
  }
  return cubics_of_arc(segment, from);
}

void straighten(PerspectiveStroke& stroke, double tolerance) {
  const bool parallel = stroke.group != StrokeGroup::Unknown && is_parallel(stroke.group);
  if (!stroke.straight && !(parallel && is_nearly_straight(stroke, tolerance))) return;
  stroke.pieces = {straight_piece(stroke.start(), stroke.end())};
  stroke.straight = true;
}

double radians_of(double degrees) { return degrees * std::numbers::pi / 180; }

double degrees_of(double radians) {
  const double exact = radians * 180 / std::numbers::pi;
  // A short number that gives the same radians is most likely what somebody wrote.
  for (int digits = 1; digits <= 17 && std::isfinite(exact); ++digits) {
    char text[40];
    const auto [end, error] = std::to_chars(text, text + sizeof text, exact, std::chars_format::general, digits);
    double shorter = 0;
    if (error == std::errc() && std::from_chars(text, end, shorter).ec == std::errc() &&
        radians_of(shorter) == radians) {
      return shorter;
    }
  }
  for (const double near : {std::nextafter(exact, 0.0), std::nextafter(exact, std::numeric_limits<double>::max())}) {
    if (radians_of(near) == radians) return near;
  }
  return exact;
}

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
