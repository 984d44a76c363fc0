// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

using Points = std::vector<Vec2>;

Points circle(std::size_t count, double radius = 1, const Vec2& center = Vec2::Zero()) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    points.emplace_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

Points wander(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  Points points = {Vec2(0, 0)};
  while (points.size() < count) points.emplace_back(points.back() + Vec2(random.between(-1, 2), random.between(-1, 1)));
  return points;
}

/// The same line walked the other way; a closed one still begins at its first point.
Points reversed(Points points, bool closed) {
  std::reverse(points.begin() + (closed && !points.empty() ? 1 : 0), points.end());
  return points;
}

double largest_difference(const Points& a, const Points& b) {
  REQUIRE(a.size() == b.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

const Points square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};

}  // namespace

TEST_CASE("length adds up segments and closes closed lines") {
  CHECK(length(square, false) == 6.0);
  CHECK(length(square, true) == 8.0);
  CHECK(length(Points{}, true) == 0.0);
  CHECK(length(Points{{3, 4}}, true) == 0.0);
  CHECK(length(circle(10000), true) == Approx(2 * std::numbers::pi));
}

TEST_CASE("resampling gives the wanted number of points at equal distances") {
  const Points samples = resample(square, true, 0.5);
  REQUIRE(samples.size() == 16);
  for (std::size_t i = 0; i < 16; ++i) {
    CHECK((samples[i] - samples[(i + 1) % 16]).norm() == Approx(0.5));
  }
  CHECK(resample(Points{{0, 0}, {10, 0}}, false, 3).size() == 4);     // 10/3 rounds to 3 segments
  CHECK(resample(Points{{0, 0}, {10, 0}}, false, 1000).size() == 2);  // an open line keeps one segment
  CHECK(resample(square, true, 1000).size() == 3);                    // a closed one three
  const Points of_circle = resample(circle(977), true, 2 * std::numbers::pi / 60);
  REQUIRE(of_circle.size() == 60);
  for (std::size_t i = 0; i < 60; ++i) {
    CHECK(of_circle[i].norm() == Approx(1.0).epsilon(1e-5));
    CHECK((of_circle[i] - of_circle[(i + 1) % 60]).norm() == Approx(2 * std::sin(std::numbers::pi / 60)).epsilon(1e-4));
  }
}

TEST_CASE("resampling keeps the ends exactly and stays on the line") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Points points = wander(seed, 30);
    const Points samples = resample(points, false, 0.37);
    CHECK(samples.front() == points.front());
    CHECK(samples.back() == points.back());
    for (const Vec2& sample : samples) CHECK(closest_point(points, false, sample).distance < 1e-12);
  }
}

TEST_CASE("resampling the other way gives the same points") {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    for (const bool closed : {false, true}) {
      const Points points = wander(seed, 3 + seed);
      const Points there = resample(points, closed, 0.21);
      const Points back = resample(reversed(points, closed), closed, 0.21);
      CHECK(largest_difference(reversed(there, closed), back) < 1e-11);
    }
  }
}

TEST_CASE("resampling scales with the line and the step") {
  const Points points = wander(7, 25);
  Points large;
  for (const Vec2& p : points) large.emplace_back(1024 * p);
  Points expected = resample(points, true, 0.3);
  for (Vec2& p : expected) p *= 1024;
  CHECK(largest_difference(resample(large, true, 0.3 * 1024), expected) == 0.0);
}

TEST_CASE("lines without a length resample to their first point") {
  CHECK(resample(Points{}, true, 1).empty());
  CHECK(resample(Points{{1, 2}}, false, 1) == Points{{1, 2}});
  CHECK(resample(Points{{1, 2}, {1, 2}, {1, 2}}, true, 1) == Points{{1, 2}});
  CHECK(resample(Points{{0, 0}, {0, 0}, {1, 0}, {1, 0}}, false, 0.5) == Points{{0, 0}, {0.5, 0}, {1, 0}});
}

TEST_CASE("steps that can't be walked are refused") {
  for (const double step : {0.0, -1.0, std::nan(""), 1e-9}) CHECK_THROWS_AS(resample(square, true, step), Error);
}

TEST_CASE("smoothing keeps the size of a circle and removes its noise") {
  Random random(5);
  Points noisy = circle(200);
  for (Vec2& p : noisy) p *= 1 + random.between(-0.01, 0.01);
  const auto roughness = [](const Points& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 middle = (points[(i + 199) % 200] + points[(i + 1) % 200]) / 2;
      sum += (points[i] - middle).squaredNorm();
    }
    return sum;
  };
  const Points smooth = taubin_smooth(noisy, true, {.passes = 20});
  CHECK(roughness(smooth) < 0.05 * roughness(noisy));
  CHECK(signed_area(smooth) == Approx(std::numbers::pi).epsilon(0.01));
}

TEST_CASE("smoothing leaves straight lines, ends, corners and fixed points alone") {
  const Points straight = {{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  CHECK(largest_difference(taubin_smooth(straight, false), straight) < 1e-15);

  const Points outline = resample(square, true, 0.25);
  const Points kept = taubin_smooth(outline, true, {.corner_angle = std::numbers::pi / 4});
  CHECK(largest_difference(kept, outline) < 1e-12);
  const Points rounded = taubin_smooth(outline, true);
  CHECK(rounded[0] != outline[0]);

  const Points points = wander(3, 12);
  TaubinOptions options;
  options.fixed.assign(points.size(), false);
  options.fixed[5] = true;
  const Points smooth = taubin_smooth(points, false, options);
  CHECK(smooth[0] == points[0]);
  CHECK(smooth[5] == points[5]);
  CHECK(smooth[6] != points[6]);
  CHECK(smooth.back() == points.back());
  options.fixed.pop_back();
  CHECK_THROWS_AS(taubin_smooth(points, false, options), Error);
}

TEST_CASE("smoothing the other way gives the same points") {
  for (const bool closed : {false, true}) {
    const Points points = wander(17, 40);
    const TaubinOptions options{.corner_angle = 1.5};
    CHECK(largest_difference(reversed(taubin_smooth(points, closed, options), closed),
                             taubin_smooth(reversed(points, closed), closed, options)) < 1e-12);
  }
  CHECK(taubin_smooth(Points{}, true).empty());
  CHECK(taubin_smooth(Points{{1, 1}}, true) == Points{{1, 1}});
}

TEST_CASE("signed area tells the direction and does not depend on the place") {
  CHECK(signed_area(square) == 4.0);
  CHECK(signed_area(reversed(square, true)) == -4.0);
  CHECK(signed_area(Points{{0, 0}, {2, 2}, {2, 0}, {0, 2}}) == 0.0);  // a figure eight
  CHECK(signed_area(circle(2000, 3)) == Approx(9 * std::numbers::pi).epsilon(1e-5));
  CHECK(signed_area(circle(500, 1, {1e7, -1e7})) == Approx(signed_area(circle(500))).epsilon(1e-7));
  CHECK(signed_area(Points{}) == 0.0);
}

TEST_CASE("winding numbers count the turns, rays through corners included") {
  CHECK(winding_number(square, {1, 1}) == 1);
  CHECK(winding_number(reversed(square, true), {1, 1}) == -1);
  CHECK(winding_number(square, {3, 1}) == 0);
  CHECK(winding_number(square, {-1, 0}) == 0);
  CHECK(winding_number(square, {-1, 2}) == 0);
  const Points diamond = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  CHECK(winding_number(diamond, {0, 0}) == 1);
  CHECK(winding_number(diamond, {-2, 0}) == 0);
  Points twice = circle(40, 2);
  const Points inner = circle(40, 1);
  twice.insert(twice.end(), inner.begin(), inner.end());
  CHECK(winding_number(twice, {0.1, 0.2}) == 2);
  CHECK(winding_number(twice, {-1.5, 0.2}) == 1);
  CHECK(winding_number(Points{}, {0, 0}) == 0);
  CHECK(winding_number(Points{{1, 1}}, {0, 0}) == 0);
}

TEST_CASE("winding numbers agree with the summed angle") {
  Random random(23);
  const Points points = wander(29, 25);
  for (int i = 0; i < 300; ++i) {
    const Vec2 at(random.between(-2, 15), random.between(-4, 4));
    double angle = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vec2 a = points[k] - at;
      const Vec2 b = points[(k + 1) % points.size()] - at;
      angle += std::atan2(cross(a, b), a.dot(b));
    }
    CHECK(winding_number(points, at) == std::lround(angle / (2 * std::numbers::pi)));
  }
}

TEST_CASE("the closest point is on the nearest segment") {
  CHECK(distance_to_segment({1, 3}, {0, 0}, {2, 0}) == 3.0);
  CHECK(distance_to_segment({5, 4}, {0, 0}, {2, 0}) == 5.0);
  CHECK(distance_to_segment({3, 4}, {0, 0}, {0, 0}) == 5.0);
  const PolylinePoint side = closest_point(square, false, {2.5, 0.5});
  CHECK(side.segment == 1);
  CHECK(side.parameter == 0.25);
  CHECK(side.position == Vec2(2, 0.5));
  CHECK(side.distance == 0.5);
  CHECK(closest_point(square, false, {-1, 1}).segment == 0);
  CHECK(closest_point(square, true, {-1, 1}).segment == 3);
  CHECK(closest_point(Points{{3, 4}}, true, {0, 0}).distance == 5.0);
  CHECK(std::isinf(closest_point(Points{}, true, {0, 0}).distance));
}

TEST_CASE("no sampled place is nearer than the closest point") {
  Random random(31);
  const Points points = wander(37, 15);
  const Points dense = resample(points, true, 0.001);
  for (int i = 0; i < 50; ++i) {
    const Vec2 at(random.between(-2, 12), random.between(-4, 4));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2& sample : dense) nearest = std::min(nearest, (sample - at).norm());
    const double found = closest_point(points, true, at).distance;
    CHECK(found <= nearest + 1e-12);
    CHECK(found >= nearest - 0.002);
  }
}
