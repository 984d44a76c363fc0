// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/perspective/perspective_strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "croquis/base/limits.h"
#include "croquis/io/perspective_drawing_file.h"
#include "io/svg/svg_color.h"
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

constexpr std::array<const char*, 7> default_colours{"#F28C00", "#1F9D3A", "#8A2BE2", "#1F4FD8",
                                                     "#D81F2A", "#E0B400", "#808080"};

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

/// HSV, degrees; nothing where the colour is too grey.
std::optional<double> hue_of(const SvgColor& rgb) {
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
  const std::optional<SvgColor> rgb = svg_color(colour);
  const std::optional<double> hue = rgb ? hue_of(*rgb) : std::nullopt;
  if (!hue) return StrokeGroup::Unknown;
  for (const HueRange& range : hue_ranges) {
    if (*hue >= range.from && *hue <= range.to) return range.group;
  }
  return StrokeGroup::Unknown;
}

std::string colour_of_group(StrokeGroup group) { return default_colours[static_cast<std::size_t>(group)]; }

}  // namespace croquis
