// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg/svg_shapes.h"

#include <algorithm>
#include <array>
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

SvgOutline line_shape(const SvgAttributes& attributes) {
  std::optional<SvgTextError> error;
  const auto at = [&](const char* name) { return svg_length(attributes, name, 0, error); };
  SvgOutline outline;
  SvgSubpath subpath;
  subpath.start = Vec2(at("x1"), at("y1"));
  subpath.segments.push_back(svg_line({at("x2"), at("y2")}));
  outline.subpaths.push_back(std::move(subpath));
  return error ? failed(*error) : outline;
}

SvgOutline ellipse_shape(const SvgAttributes& attributes, bool circle) {
  std::optional<SvgTextError> error;
  const auto at = [&](const char* name) { return svg_length(attributes, name, 0, error); };
  const double radius_x = at(circle ? "r" : "rx");
  const double radius_y = circle ? radius_x : at("ry");
  const Vec2 centre(at("cx"), at("cy"));
  if (!error && (radius_x < 0 || radius_y < 0)) error = SvgTextError{"has a negative radius", 0};
  if (error) return failed(*error);
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

SvgOutline rect_shape(const SvgAttributes& attributes) {
  std::optional<SvgTextError> error;
  const auto at = [&](const char* name, double fallback) { return svg_length(attributes, name, fallback, error); };
  const Vec2 low(at("x", 0), at("y", 0));
  const Vec2 size(at("width", 0), at("height", 0));
  Vec2 radius(at("rx", not_given), at("ry", not_given));
  if (!error && size.minCoeff() < 0) error = SvgTextError{"has a negative width or height", 0};
  if (error) return failed(*error);
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

double svg_length(const SvgAttributes& attributes, const char* name, double fallback,
                  std::optional<SvgTextError>& error) {
  const std::string_view text = trimmed(attributes(name));
  if (text.empty() || text == "auto") return fallback;
  SvgScanner scanner(text);
  const std::optional<double> value = scanner.number();
  const std::string_view unit = scanner.word();
  const auto known = std::find_if(pixels_per_unit.begin(), pixels_per_unit.end(),
                                  [&](const auto& entry) { return entry.first == unit; });
  if (value && scanner.at_end() && known != pixels_per_unit.end()) return *value * known->second;
  if (!error) error = SvgTextError{std::string("has ") + name + "=" + in_quotes(text) + ", which is no length", 0};
  return fallback;
}

bool is_svg_shape(std::string_view element) {
  constexpr std::array<std::string_view, 7> shapes{"path", "polyline", "polygon", "line", "rect", "circle", "ellipse"};
  return std::find(shapes.begin(), shapes.end(), element) != shapes.end();
}

SvgOutline svg_shape(std::string_view element, const SvgAttributes& attributes) {
  if (element == "polyline" || element == "polygon") {
    return parse_svg_points(attributes("points"), element == "polygon");
  }
  if (element == "line") return line_shape(attributes);
  if (element == "rect") return rect_shape(attributes);
  if (element == "circle" || element == "ellipse") return ellipse_shape(attributes, element == "circle");
  const std::string_view data = attributes("d");
  return trimmed(data) == "none" ? SvgOutline{} : parse_svg_path(data);
}

}  // namespace croquis
