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

TEST_CASE("a corner that is cut off in steps is one where lines are compared over a reach") {
  Points rounded;
  for (int side = 0; side < 4; ++side) {
    const double angle = side * std::numbers::pi / 2;
    const Vec2 along(std::cos(angle), std::sin(angle)), start = -along + Vec2(along.y(), -along.x());
    for (int k = 1; k < 20; ++k) rounded.push_back(start + 0.1 * k * along);
  }
  CHECK(corners_of(rounded, true, 0.1, std::numbers::pi / 3).empty());
  CHECK(corners_of(rounded, true, 0.5, std::numbers::pi / 3).size() == 4);
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

  Points outline;
  for (std::size_t side = 0; side < 4; ++side) {
    for (int i = 0; i < 8; ++i) outline.emplace_back(square[side] + i / 8.0 * (square[(side + 1) % 4] - square[side]));
  }
  TaubinOptions corners;
  corners.fixed.assign(outline.size(), false);
  for (std::size_t i = 0; i < outline.size(); i += 8) corners.fixed[i] = true;
  CHECK(largest_difference(taubin_smooth(outline, true, corners), outline) < 1e-12);
  CHECK(taubin_smooth(outline, true)[0] != outline[0]);

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
    CHECK(largest_difference(reversed(taubin_smooth(points, closed), closed),
                             taubin_smooth(reversed(points, closed), closed)) < 1e-12);
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

TEST_CASE("the nearest place on a segment is nearer than all others, ends included") {
  Random random(7);
  for (int round = 0; round < 200; ++round) {
    const auto place = [&random] { return Vec2(random.between(-1, 1), random.between(-1, 1)); };
    const Vec2 a = place();
    const Vec2 b = place();
    const Vec2 point = place();
    const double nearest = nearest_parameter(point, a, b);
    const double distance = (a + nearest * (b - a) - point).norm();
    for (int i = 0; i <= 50; ++i) CHECK(distance <= (a + i / 50.0 * (b - a) - point).norm() + 1e-15);
  }
  CHECK(nearest_parameter(Vec2(3, 4), Vec2(1, 1), Vec2(1, 1)) == 0.0);
}
