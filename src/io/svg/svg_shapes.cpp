// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg/svg_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "io/text.h"

namespace croquis {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double most_pieces = 65536;

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Where what belongs to a kind of characters ends.
template <typename Is>
std::size_t end_of(std::string_view text, std::size_t from, const Is& is) {
  while (from < text.size() && is(text[from])) ++from;
  return from;
}

bool is_one_of(std::string_view text, std::size_t at, std::string_view characters) {
  return at < text.size() && characters.find(text[at]) != std::string_view::npos;
}

/// The end of the number that begins at a place; the place itself when none does.
std::size_t end_of_number(std::string_view text, std::size_t from) {
  const std::size_t begin = is_one_of(text, from, "+-") ? from + 1 : from;
  const std::size_t whole = end_of(text, begin, is_digit);
  const bool has_point = is_one_of(text, whole, ".");
  std::size_t end = has_point ? end_of(text, whole + 1, is_digit) : whole;
  if (end - begin == (has_point ? 1U : 0U)) return from;  // no digits
  if (is_one_of(text, end, "eE")) {
    const std::size_t exponent = is_one_of(text, end + 1, "+-") ? end + 2 : end + 1;
    const std::size_t last = end_of(text, exponent, is_digit);
    if (last > exponent) end = last;  // else the e begins a unit
  }
  return end;
}

}  // namespace

void SvgScanner::skip_blanks() { position_ = end_of(text_, position_, is_space); }

void SvgScanner::skip_separators() {
  skip_blanks();
  if (peek() != ',') return;
  ++position_;
  skip_blanks();
}

std::optional<double> SvgScanner::number() {
  const std::size_t end = end_of_number(text_, position_);
  if (end > position_) {
    double value = 0;
    parse_number(text_.substr(position_, end - position_), value);
    position_ = end;
    return value;
  }
  const std::size_t at = is_one_of(text_, position_, "+-") ? position_ + 1 : position_;
  for (const std::string_view name : {"infinity", "inf", "nan"}) {
    if (lower_case(text_.substr(at, name.size())) != name) continue;
    position_ = at + name.size();
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::nullopt;
}

std::optional<bool> SvgScanner::flag() {
  if (peek() != '0' && peek() != '1') return std::nullopt;
  return take() == '1';
}

std::string_view SvgScanner::word() {
  const std::size_t begin = position_;
  position_ = end_of(text_, begin, is_letter);
  return text_.substr(begin, position_ - begin);
}

namespace {

/// Angle from u to v in (-pi, pi].
double signed_angle(const Vec2& u, const Vec2& v) { return std::atan2(cross(u, v), u.dot(v)); }

/// Centre of the unit circle through p and q that the two flags choose (F.6.5, in the frame where radii are 1).
Vec2 unit_centre(const Vec2& p, const Vec2& q, const SvgArcShape& shape) {
  const Vec2 half = (q - p) / 2;
  const double apart = half.squaredNorm();
  const double away = std::sqrt(std::max(0.0, (1 - apart) / apart));
  const double side = shape.large == shape.positive ? -1 : 1;
  return (p + q) / 2 + side * away * left_of(half);
}

}  // namespace

SvgSegment svg_line(const Vec2& end) {
  SvgSegment segment;
  segment.end = end;
  return segment;
}

SvgSegment svg_cubic(const Vec2& a, const Vec2& b, const Vec2& end) {
  SvgSegment segment = svg_line(end);
  segment.kind = SvgSegment::Kind::Cubic;
  segment.a = a;
  segment.b = b;
  return segment;
}

SvgSegment svg_arc(const Vec2& from, const SvgArcShape& shape, const Vec2& to) {
  SvgSegment segment = svg_line(to);
  const Vec2 radii(std::abs(shape.radius_x), std::abs(shape.radius_y));
  if (radii.minCoeff() == 0 || from == to) return segment;
  const Eigen::Rotation2Dd turn(std::remainder(shape.rotation, 360.0) * pi / 180);
  // The frame in which the ellipse is a unit circle about some centre, with `from` as origin to keep digits.
  const Vec2 chord = (turn.inverse() * (to - from)).cwiseQuotient(radii);
  const double scale = std::max(1.0, chord.norm() / 2);
  const Vec2 q = chord / scale;
  if (!q.allFinite() || q.norm() == 0) return segment;
  const Vec2 centre = unit_centre(Vec2::Zero(), q, shape);
  segment.kind = SvgSegment::Kind::Arc;
  segment.a = scale * radii.x() * (turn * Vec2::UnitX());
  segment.b = scale * radii.y() * (turn * Vec2::UnitY());
  segment.centre = from + centre.x() * segment.a + centre.y() * segment.b;
  segment.angle = std::atan2(-centre.y(), -centre.x());
  segment.sweep = signed_angle(-centre, q - centre);
  if (shape.positive && segment.sweep < 0) segment.sweep += 2 * pi;
  if (!shape.positive && segment.sweep > 0) segment.sweep -= 2 * pi;
  return segment;
}

SvgSubpath svg_ellipse(const Vec2& centre, double radius_x, double radius_y) {
  SvgSubpath subpath;
  subpath.start = centre + Vec2(radius_x, 0);
  subpath.closed = true;
  SvgSegment turn;
  turn.kind = SvgSegment::Kind::Arc;
  turn.end = subpath.start;
  turn.a = Vec2(radius_x, 0);
  turn.b = Vec2(0, radius_y);
  turn.centre = centre;
  turn.sweep = 2 * pi;
  subpath.segments.push_back(turn);
  return subpath;
}

void transform(SvgSubpath& subpath, const Eigen::Affine2d& map) {
  subpath.start = map * subpath.start;
  for (SvgSegment& segment : subpath.segments) {
    const bool arc = segment.kind == SvgSegment::Kind::Arc;
    segment.end = map * segment.end;
    segment.a = arc ? Vec2(map.linear() * segment.a) : Vec2(map * segment.a);
    segment.b = arc ? Vec2(map.linear() * segment.b) : Vec2(map * segment.b);
    segment.centre = map * segment.centre;
  }
}

Vec2 point_on(const SvgSegment& segment, const Vec2& from, double t) {
  if (t >= 1) return segment.end;
  const double s = 1 - t;
  switch (segment.kind) {
    case SvgSegment::Kind::Line: return s * from + t * segment.end;
    case SvgSegment::Kind::Cubic:
      return s * s * s * from + 3 * s * s * t * segment.a + 3 * s * t * t * segment.b + t * t * t * segment.end;
    case SvgSegment::Kind::Arc: break;
  }
  const double angle = segment.angle + t * segment.sweep;
  return segment.centre + std::cos(angle) * segment.a + std::sin(angle) * segment.b;
}

int pieces_within(const SvgSegment& segment, const Vec2& from, double tolerance) {
  // A chord over a parameter step h is at most |c''| h^2 / 8 away from its curve.
  double bend = 0;
  if (segment.kind == SvgSegment::Kind::Cubic) {
    const double first = (from - 2 * segment.a + segment.b).norm();
    const double second = (segment.a - 2 * segment.b + segment.end).norm();
    bend = 6 * std::max(first, second);
  } else if (segment.kind == SvgSegment::Kind::Arc) {
    bend = std::hypot(segment.a.norm(), segment.b.norm()) * segment.sweep * segment.sweep;
  }
  if (bend == 0 || tolerance <= 0) return 1;
  const double pieces = std::ceil(std::sqrt(bend / (8 * tolerance)));
  return std::isfinite(pieces) ? static_cast<int>(std::clamp(pieces, 1.0, most_pieces)) : 1;
}

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
  if (unit != "%" || viewport_.minCoeff() <= 0) return std::nullopt;
  if (name == "r") return viewport_.norm() / std::numbers::sqrt2 / 100;
  const bool across = name == "width" || name.find('x') != std::string_view::npos;
  return (across ? viewport_.x() : viewport_.y()) / 100;
}

double SvgLengths::at(const char* name, double fallback) {
  const std::string_view text = trimmed(element_.attribute(name).value());
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

SvgOutline svg_shape(std::string_view element, const pugi::xml_node& node, const Vec2& viewport) {
  SvgLengths lengths(node, viewport);
  if (element == "polyline" || element == "polygon") {
    return parse_svg_points(node.attribute("points").value(), element == "polygon");
  }
  if (element == "line") return line_shape(lengths);
  if (element == "rect") return rect_shape(lengths);
  if (element == "circle" || element == "ellipse") return ellipse_shape(lengths, element == "circle");
  const std::string_view data = node.attribute("d").value();
  return trimmed(data) == "none" ? SvgOutline{} : parse_svg_path(data);
}

}  // namespace croquis
