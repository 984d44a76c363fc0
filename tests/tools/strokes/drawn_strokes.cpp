// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/strokes/drawn_strokes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace croquis::test {
namespace {

constexpr double pi = std::numbers::pi;

Vec2 turned(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

std::function<Vec2(double)> polyline(std::vector<Vec2> corners) {
  return [corners](double t) {
    const double along = t * static_cast<double>(corners.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(along), corners.size() - 2);
    return Vec2(corners[i] + (along - static_cast<double>(i)) * (corners[i + 1] - corners[i]));
  };
}

std::vector<Vec2> zigzag(int teeth) {
  std::vector<Vec2> corners;
  for (int i = 0; i <= teeth; ++i) corners.push_back({40.0 * i, i % 2 == 0 ? 0.0 : 60.0});
  return corners;
}

}  // namespace

std::vector<DrawnCurve> drawn_curves() {
  return {
      {"small circle", [](double t) { return turned(25, 2 * pi * t); }, 60, true, 0},
      {"circle", [](double t) { return turned(200, 2 * pi * t); }, 300, true, 0},
      {"dense circle", [](double t) { return turned(150, 2 * pi * t); }, 3000, true, 0},
      {"spiral", [](double t) { return turned(20 + 200 * t, 6 * pi * t); }, 800, false, 0},
      {"wave", [](double t) { return Vec2(600 * t, 80 * std::sin(4 * pi * t)); }, 400, false, 0},
      {"uneven pace", [](double t) { return Vec2(500 * t * t, 90 * std::sin(7 * t * t)); }, 300, false, 0},
      {"straight line", [](double t) { return Vec2(300 * t, 100 * t); }, 150, false, 0},
      {"zigzag", polyline(zigzag(8)), 801, false, 7},
      {"square", polyline({{0, 0}, {200, 0}, {200, 200}, {0, 200}, {0, 0}}), 400, true, 4},
      {"square from the middle of a side", polyline({{100, 0}, {200, 0}, {200, 200}, {0, 200}, {0, 0}, {100, 0}}), 500,
       true, 4},
      {"drop",
       [](double t) { return Vec2(160 * std::pow(std::sin(pi * t), 2), 90 * std::sin(2 * pi * t) * std::sin(pi * t)); },
       300, true, 1},
      {"fast arc", [](double t) { return turned(300, pi * t); }, 12, false, 0},
  };
}

Stroke sampled(const DrawnCurve& curve, const std::string& id) {
  Stroke stroke;
  stroke.id = id;
  stroke.closed = curve.closed;
  const auto steps = static_cast<double>(curve.closed ? curve.samples : curve.samples - 1);
  for (std::size_t i = 0; i < curve.samples; ++i) {
    const auto k = static_cast<double>(i);
    stroke.samples.push_back({curve.at(k / steps), 0.5, Vec2::Zero(), k / 300});
  }
  return stroke;
}

Vec2 jitter(Random& random, double deviation) {
  const auto one = [&] {
    double sum = 0;
    for (int i = 0; i < 12; ++i) sum += random.unit();
    return deviation * (sum - 6);
  };
  const double x = one();
  return {x, one()};
}

Stroke stroke_through(const std::vector<Vec2>& places, const std::string& id, bool closed) {
  Stroke stroke;
  stroke.id = id;
  stroke.closed = closed;
  for (std::size_t i = 0; i < places.size(); ++i)
    stroke.samples.push_back({places[i], 0.5, Vec2::Zero(), static_cast<double>(i) / 300});
  return stroke;
}

Stroke circle(const std::string& id, const Vec2& centre, double radius, std::size_t samples) {
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < samples; ++i)
    places.push_back(centre + turned(radius, 2 * pi * static_cast<double>(i) / static_cast<double>(samples)));
  return stroke_through(places, id, true);
}

}  // namespace croquis::test
