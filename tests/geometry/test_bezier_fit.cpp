// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/geometry/attribute_network.h"
#include "croquis/geometry/bezier_fit.h"
#include "support/random.h"

namespace croquis::test {
namespace {

Vec3 random_point(Random& random) { return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}; }

std::vector<Vec3> samples_of(const std::vector<Vec3>& control, std::size_t count) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i <= count; ++i)
    points.push_back(bezier_point(control, static_cast<double>(i) / static_cast<double>(count)));
  return points;
}

double distance_to(const FittedBezier& curve, const Vec3& point) {
  double least = 1e300;
  const std::vector<Vec3> places = samples_of(curve.control, 400);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Vec3 along = places[i + 1] - places[i];
    const double t = std::clamp((point - places[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (places[i] + t * along - point).norm());
  }
  return least;
}

/// A row that turns smoothly through space without an end of its own.
std::vector<Vec3> spiral(double turns, std::size_t count) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i <= count; ++i) {
    const double t = 2 * std::numbers::pi * turns * static_cast<double>(i) / static_cast<double>(count);
    points.push_back({std::cos(t) * (1 + t / 10), std::sin(t) * (1 + t / 10), t / 7});
  }
  return points;
}

TEST_CASE("points of one Bezier curve are fitted by one curve") {
  Random random(5);
  for (std::size_t degree = 1; degree <= 5; ++degree) {
    for (int trial = 0; trial < 20; ++trial) {
      // Control points in a row, so that the curve has no cusp.
      std::vector<Vec3> control;
      for (std::size_t j = 0; j <= degree; ++j)
        control.push_back(Vec3(static_cast<double>(j), 0, 0) + 0.25 * random_point(random));
      BezierFitOptions options;
      options.tolerance = 1e-3;
      const std::vector<Vec3> points = samples_of(control, 60);
      const auto curves = fit_beziers(points, options);
      INFO("degree " << degree << ", trial " << trial);
      REQUIRE(curves.size() == 1);
      for (const Vec3& point : points) CHECK(distance_to(curves[0], point) < 1.01e-3);
    }
  }
}

TEST_CASE("fitted chains keep the tolerance, meet their points' ends and turn nowhere") {
  for (const double turns : {0.3, 1.0, 3.0}) {
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
      INFO(turns << " turns, tolerance " << tolerance);
      const std::vector<Vec3> points = spiral(turns, 500);
      BezierFitOptions options;
      options.tolerance = tolerance;
      const auto curves = fit_beziers(points, options);
      CHECK(curves.front().first == 0);
      CHECK(curves.back().last == points.size() - 1);
      for (std::size_t k = 0; k < curves.size(); ++k) {
        const FittedBezier& curve = curves[k];
        CHECK(curve.control.front() == points[curve.first]);
        CHECK(curve.control.back() == points[curve.last]);
        for (std::size_t i = curve.first; i <= curve.last; i += 7)
          CHECK(distance_to(curve, points[i]) < tolerance + 2e-6);  // what the test's chords leave
        if (k == 0) continue;
        const auto& before = curves[k - 1].control;
        CHECK(curve.first == curves[k - 1].last);
        CHECK(angle_between(before.back() - before[before.size() - 2], curve.control[1] - curve.control[0]) < 1e-7);
      }
    }
  }
}

TEST_CASE("a finer tolerance takes more curves, or a higher degree") {
  const std::vector<Vec3> points = spiral(2, 800);
  std::size_t before = 0;
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
    BezierFitOptions options;
    options.tolerance = tolerance;
    std::size_t control = 0;
    for (const FittedBezier& curve : fit_beziers(points, options)) control += curve.control.size();
    CHECK(control > before);
    before = control;
  }
}

TEST_CASE("given directions are kept") {
  Random random(11);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<Vec3> points = spiral(random.between(0.1, 0.4), 40);
    BezierFitOptions options;
    options.tolerance = 0.01;
    const Vec3 along = (points[1] - points[0]).normalized(), arriving = (points[40] - points[39]).normalized();
    options.start_direction = (along + 0.2 * random_point(random)).normalized();
    options.end_direction = (arriving + 0.2 * random_point(random)).normalized();
    const auto curves = fit_beziers(points, options);
    const auto &first = curves.front().control, &last = curves.back().control;
    CHECK(angle_between(first[1] - first[0], *options.start_direction) < 1e-7);
    CHECK(angle_between(last.back() - last[last.size() - 2], *options.end_direction) < 1e-7);
  }
}

TEST_CASE("few points are met without swinging out between them") {
  for (const std::size_t count : {2U, 3U, 4U, 5U, 8U}) {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i <= count; ++i) {
      const double t = std::numbers::pi / 2 * static_cast<double>(i) / static_cast<double>(count);
      points.push_back({std::cos(t), std::sin(t), 0});
    }
    BezierFitOptions options;
    options.tolerance = 0.01;
    const auto curves = fit_beziers(points, options);
    INFO(count << " chords of a quarter circle");
    REQUIRE(curves.size() == 1);
    for (const Vec3& place : samples_of(curves[0].control, 200)) CHECK(std::abs(place.norm() - 1) < 0.03);
  }
}

TEST_CASE("straight rows become straight curves") {
  std::vector<Vec3> points;
  for (int i = 0; i <= 20; ++i) points.push_back(Vec3(1, 2, 3) + i * i * Vec3(0.5, -0.25, 2));
  BezierFitOptions options;
  options.tolerance = 1e-6;
  const auto curves = fit_beziers(points, options);
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].control.size() == 2);
}

}  // namespace
}  // namespace croquis::test
