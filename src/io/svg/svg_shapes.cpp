// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg/svg_shapes.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <utility>

#include "io/text.h"

namespace croquis {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 7> pixels_per_unit{
    {{"", 1}, {"px", 1}, {"in", 96}, {"mm", 96 / 25.4}, {"cm", 96 / 2.54}, {"pt", 96.0 / 72}, {"pc", 16}}};

constexpr double not_given = -1;

SvgOutline failed(SvgTextError error) {
  SvgOutline outline;
  outline.error = std::move(error);
  return outline;
}

SvgOutline line_shape(SvgLengths& lengths) {
  SvgOutline outline;
  SvgSubpath subpath;
  subpath.start = Vec2(lengths.at("x1"), lengths.at("y1"));
  subpath.segments.push_back(svg_line({lengths.at("x2"), lengths.at("y2")}));
  outline.subpaths.push_back(std::move(subpath));
  return lengths.error() ? failed(*lengths.error()) : outline;
}

SvgOutline ellipse_shape(SvgLengths& lengths, bool circle) {
  const double radius_x = lengths.at(circle ? "r" : "rx");
  const double radius_y = circle ? radius_x : lengths.at("ry");
  const Vec2 centre(lengths.at("cx"), lengths.at("cy"));
  if (lengths.error()) return failed(*lengths.error());
  if (radius_x < 0 || radius_y < 0) return failed({"has a negative radius", 0});
  SvgOutline outline;
  if (radius_x != 0 && radius_y != 0) outline.subpaths.push_back(svg_ellipse(centre, radius_x, radius_y));
  return outline;
}

/// Clockwise on the page from the end of the first corner (SVG 1.1, 9.2).
SvgSubpath rounded_box(const Vec2& low, const Vec2& high, const Vec2& radius) {
  SvgSubpath box;
  box.closed = true;
  box.start = Vec2(low.x() + radius.x(), low.y());
  const SvgArcShape corner{radius.x(), radius.y(), 0, false, true};
  const auto side = [&](const Vec2& end, const Vec2& corner_end) {
    box.segments.push_back(svg_line(end));
    if (corner_end != end) box.segments.push_back(svg_arc(end, corner, corner_end));
  };
  side({high.x() - radius.x(), low.y()}, {high.x(), low.y() + radius.y()});
  side({high.x(), high.y() - radius.y()}, {high.x() - radius.x(), high.y()});
  side({low.x() + radius.x(), high.y()}, {low.x(), high.y() - radius.y()});
  side({low.x(), low.y() + radius.y()}, {low.x() + radius.x(), low.y()});
  return box;
}

SvgOutline rect_shape(SvgLengths& lengths) {
  const Vec2 low(lengths.at("x"), lengths.at("y"));
  const Vec2 size(lengths.at("width"), lengths.at("height"));
  Vec2 radius(lengths.at("rx", not_given), lengths.at("ry", not_given));
  if (lengths.error()) return failed(*lengths.error());
  if (size.minCoeff() < 0) return failed({"has a negative width or height", 0});
  // One missing radius is the other one; with neither there are corners.
  if (radius.x() < 0) radius.x() = std::max(0.0, radius.y());
  if (radius.y() < 0) radius.y() = radius.x();
  radius = radius.cwiseMin(size / 2);
  if (radius.minCoeff() == 0) radius.setZero();
  SvgOutline outline;
  if (size.x() != 0 && size.y() != 0) outline.subpaths.push_back(rounded_box(low, low + size, radius));
  return outline;
}

}  // namespace

/// User units per unit; nothing for units that aren't known, and percents of nothing.
std::optional<double> SvgLengths::factor_of(std::string_view unit, std::string_view name) const {
  const auto known = std::find_if(pixels_per_unit.begin(), pixels_per_unit.end(),
                                  [&](const auto& entry) { return entry.first == unit; });
  if (known != pixels_per_unit.end()) return known->second;
  const Vec2& size = viewport_.size;
  if (unit != "%" || size.minCoeff() <= 0) return std::nullopt;
  if (name == "r") return size.norm() / std::numbers::sqrt2 / 100;
  const bool across = name == "width" || name.find('x') != std::string_view::npos;
  return (across ? size.x() : size.y()) / 100;
}

double SvgLengths::at(const char* name, double fallback) {
  const std::string_view text = trimmed(attributes_(name));
  if (text.empty() || text == "auto") return fallback;
  SvgScanner scanner(text);
  const std::optional<double> value = scanner.number();
  const std::optional<double> factor = factor_of(text.substr(scanner.position()), name);
  if (value && factor) return *value * *factor;
  if (!error_) error_ = SvgTextError{std::string("has ") + name + "=" + in_quotes(text) + ", which is no length", 0};
  return fallback;
}

bool is_svg_shape(std::string_view element) {
  constexpr std::array<std::string_view, 7> shapes{"path", "polyline", "polygon", "line", "rect", "circle", "ellipse"};
  return std::find(shapes.begin(), shapes.end(), element) != shapes.end();
}

SvgOutline svg_shape(std::string_view element, const SvgAttributes& attributes, const SvgViewport& viewport) {
  SvgLengths lengths(attributes, viewport);
  if (element == "polyline" || element == "polygon") {
    return parse_svg_points(attributes("points"), element == "polygon");
  }
  if (element == "line") return line_shape(lengths);
  if (element == "rect") return rect_shape(lengths);
  if (element == "circle" || element == "ellipse") return ellipse_shape(lengths, element == "circle");
  const std::string_view data = attributes("d");
  return trimmed(data) == "none" ? SvgOutline{} : parse_svg_path(data);
}

}  // namespace croquis
