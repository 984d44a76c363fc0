// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "support/sketches/sketch_layers.h"
#include "support/sketches/sketch_spline.h"

namespace croquis::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double spacing = 3;

void add(Drawing& drawing, const std::vector<Vec2>& points, bool closed) {
  drawing.strokes.push_back(stroke_of("s" + std::to_string(drawing.strokes.size()), points, closed));
}

void add_circle(Drawing& drawing, const Vec2& centre, double radius) {
  add(drawing, circle_outline(centre, radius, spacing), true);
}

/// Counterclockwise from one angle to a larger one, in degrees.
void add_arc(Drawing& drawing, const Vec2& centre, double radius, double from, double to) {
  const int count = std::max(8, static_cast<int>((to - from) * pi / 180 * radius / spacing));
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = (from + (to - from) * i / count) * pi / 180;
    points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  add(drawing, points, false);
}

void add_spline(Drawing& drawing, const std::vector<Vec2>& through) {
  const Spline spline(through, false);
  double length = 0;
  for (std::size_t i = 1; i < through.size(); ++i) length += (through[i] - through[i - 1]).norm();
  const int count = static_cast<int>(length / spacing) + 4;
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) points.push_back(spline.at(static_cast<double>(i) / count));
  add(drawing, points, false);
}

ErrorSketch tiny() {
  ErrorSketch sketch{"W_TINY", {"s1"}, {}, {}};
  add_circle(sketch.drawing, {400, 350}, 250);
  add(sketch.drawing, {{760, 350}, {762, 351}, {764, 351.5}}, false);
  return sketch;
}

/// Two half circles with 10 units missing between them at either side; u is 0.7 here.
ErrorSketch gap() {
  ErrorSketch sketch{"W_GAP", {"s0", "s1"}, {}, {}};
  const double missing = 5.0 / 250 * 180 / pi;
  add_arc(sketch.drawing, {450, 350}, 250, missing, 180 - missing);
  add_arc(sketch.drawing, {450, 350}, 250, 180 + missing, 360 - missing);
  return sketch;
}

ErrorSketch double_line() {
  ErrorSketch sketch{"W_DOUBLE", {"s0", "s1"}, {}, {}};
  add_circle(sketch.drawing, {450, 350}, 250);
  add_circle(sketch.drawing, {450, 350}, 251.2);
  return sketch;
}

void tell_all(Drawing& drawing, const std::string& kind) {
  for (Stroke& stroke : drawing.strokes) stroke.data["kind"] = kind;
}

/// Half a circle can't be closed.
ErrorSketch wrong_kind() {
  ErrorSketch sketch{"E_KIND", {"s0"}, {}, {}};
  add_arc(sketch.drawing, {450, 350}, 250, 90, 270);
  tell_all(sketch.drawing, "part");
  return sketch;
}

ErrorSketch visible_crossing() {
  ErrorSketch sketch{"E_CROSS", {"s0", "s1"}, {}, {}};
  add_circle(sketch.drawing, {330, 350}, 180);
  add_circle(sketch.drawing, {560, 360}, 170);
  return sketch;
}

/// A handle whose two ends go under two discs apart from each other: its hidden line would lie open between them.
ErrorSketch no_labelling() {
  ErrorSketch sketch{"E_NO_LABELLING", {"s2"}, {}, {}};
  add_circle(sketch.drawing, {250, 250}, 130);
  add_circle(sketch.drawing, {650, 250}, 130);
  add_spline(sketch.drawing, {{250, 380}, {250, 440}, {310, 560}, {450, 610}, {590, 560}, {650, 440}, {650, 380}});
  tell_all(sketch.drawing, "part");
  return sketch;
}

/// Straight left and right sides, round top and bottom.
std::vector<Vec2> stadium(double left, double right, double low, double high) {
  const double radius = (right - left) / 2;
  std::vector<Vec2> points;
  for (double y = low; y < high; y += spacing) points.emplace_back(right, y);
  for (double angle = 0; angle < 180; angle += 2) {
    points.emplace_back((left + right) / 2 + radius * std::cos(angle * pi / 180),
                        high + radius * std::sin(angle * pi / 180));
  }
  for (double y = high; y > low; y -= spacing) points.emplace_back(left, y);
  for (double angle = 180; angle < 360; angle += 2) {
    points.emplace_back((left + right) / 2 + radius * std::cos(angle * pi / 180),
                        low + radius * std::sin(angle * pi / 180));
  }
  return points;
}

/// Two rounded boxes side by side that share a straight side of 180 units.
ErrorSketch touching() {
  ErrorSketch sketch{"E_TOUCH", {"s0", "s1"}, {}, {}};
  add(sketch.drawing, stadium(200, 450, 260, 440), true);
  add(sketch.drawing, stadium(450, 700, 260, 440), true);
  tell_all(sketch.drawing, "part");
  return sketch;
}

}  // namespace

std::vector<ErrorSketch> error_sketches() {
  return {tiny(), gap(), double_line(), wrong_kind(), visible_crossing(), no_labelling(), touching()};
}

ErrorSketch error_sketch(const std::string& code) {
  for (ErrorSketch& sketch : error_sketches()) {
    if (sketch.code == code) return sketch;
  }
  throw std::out_of_range("no error sketch for " + code);
}

}  // namespace croquis::test
