// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>

#include "croquis/geometry/attribute_network.h"
#include "croquis/tools/surface/stroke_curves.h"
#include "tools/surface/surface_hand.h"

namespace croquis {
namespace {

using test::Random;

/// A way in pixels, drawn by hand onto an inclined plane with 0.01 model units per pixel.
std::vector<Vec3> drawn(const std::function<Vec2(double)>& way, Random& random) {
  std::vector<Vec2> dense;
  for (int i = 0; i <= 400; ++i) dense.push_back(way(i / 400.0));
  std::vector<Vec3> points;
  for (const Vec2& pixel : test::by_hand(dense, random))
    points.push_back(0.01 * (pixel.x() * Vec3(1, 0, 0) + pixel.y() * Vec3(0, 0.6, 0.8)) + Vec3(5, -3, 2));
  return points;
}

std::vector<std::vector<Vec3>> curves_drawn(const std::function<Vec2(double)>& way, Random& random) {
  StrokeCurveOptions options;
  options.unit = 0.01;
  return curves_of_stroke(drawn(way, random), options);
}

/// The greatest distance in pixels of a stroke's places from curves.
double farthest(const std::vector<Vec3>& points, const std::vector<std::vector<Vec3>>& curves) {
  double farthest = 0;
  for (const Vec3& point : points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& control : curves) {
      for (int i = 0; i <= 400; ++i) nearest = std::min(nearest, (bezier_point(control, i / 400.0) - point).norm());
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest / 0.01;
}

Vec2 arc(double angle, double radius) { return radius * Vec2(std::cos(angle), std::sin(angle)); }

TEST_CASE("strokes drawn straight by a hand are lines, at any length") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const Vec2 end = arc(random.between(0, 6), random.between(40, 600));
    const auto curves = curves_drawn([&](double t) { return Vec2(t * end); }, random);
    INFO("seed " << seed);
    REQUIRE(curves.size() == 1);
    CHECK(curves[0].size() == 2);
  }
}

TEST_CASE("bent strokes are one curve of low degree that keeps to what was drawn") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const double span = random.between(0.8, 2.6), radius = random.between(80, 300);
    const bool wave = seed % 3 == 0;
    const auto way = [&](double t) {
      return wave ? Vec2(400 * t, 60 * std::sin(2 * std::numbers::pi * t)) : arc(span * t, radius);
    };
    Random again = random;
    const auto points = drawn(way, again);
    const auto curves = curves_drawn(way, random);
    INFO("seed " << seed);
    REQUIRE(curves.size() == 1);
    CHECK(curves[0].size() >= 3);
    CHECK(curves[0].size() <= 8);
    CHECK(farthest(points, curves) < 4);  // the fit's tolerance, and what steadying took away
    CHECK((curves[0].front() - points.front()).norm() < 1e-12);
    CHECK((curves[0].back() - points.back()).norm() < 1e-12);
  }
}

TEST_CASE("strokes with sharp corners are a curve for each part") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const int parts = 2 + static_cast<int>(random.below(3));
    std::vector<Vec2> corners = {Vec2::Zero()};
    double heading = random.between(0, 6);
    for (int i = 0; i < parts; ++i) {
      corners.emplace_back(corners.back() + arc(heading, random.between(120, 200)));
      heading += (i % 2 == 0 ? 1 : -1) * random.between(1.2, 2.0);
    }
    const auto way = [&](double t) {
      const double along = t * parts;
      const auto i = std::min(static_cast<std::size_t>(along), corners.size() - 2);
      return Vec2(corners[i] + (along - static_cast<double>(i)) * (corners[i + 1] - corners[i]));
    };
    const auto curves = curves_drawn(way, random);
    INFO("seed " << seed << ", " << parts << " parts");
    REQUIRE(curves.size() == static_cast<std::size_t>(parts));
    for (std::size_t i = 0; i + 1 < curves.size(); ++i) CHECK(curves[i].back() == curves[i + 1].front());
  }
}

TEST_CASE("a stroke round and back to its beginning is closed") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const bool square = seed % 2 == 0;
    const auto way = [&](double t) {
      if (!square) return arc(2 * std::numbers::pi * t, 120);
      const double along = 4 * t;
      const Vec2 corners[] = {{0, 0}, {200, 0}, {200, 150}, {0, 150}, {0, 0}};
      const auto i = std::min(static_cast<std::size_t>(along), std::size_t{3});
      return Vec2(corners[i] + (along - static_cast<double>(i)) * (corners[i + 1] - corners[i]));
    };
    const auto curves = curves_drawn(way, random);
    INFO("seed " << seed);
    CHECK(curves.size() == 4);
    for (std::size_t i = 0; i < curves.size(); ++i) CHECK(curves[i].back() == curves[(i + 1) % curves.size()].front());
  }
}

TEST_CASE("taps and repeated points are nothing, few points are enough") {
  CHECK(curves_of_stroke(std::vector<Vec3>{}).empty());
  CHECK(curves_of_stroke(std::vector<Vec3>(20, Vec3(1, 2, 3))).empty());
  CHECK(curves_of_stroke(std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}}).empty());
  CHECK(curves_of_stroke(std::vector<Vec3>{{0, 0, 0}, {300, 0, 0}}).size() == 1);
  CHECK(curves_of_stroke(std::vector<Vec3>{{0, 0, 0}, {100, 40, 0}, {200, 0, 0}}).size() >= 1);
}

}  // namespace
}  // namespace croquis
