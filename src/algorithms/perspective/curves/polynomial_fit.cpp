// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "croquis/perspective/curve_lifting.h"

namespace croquis {
namespace {

constexpr int fit_rounds = 30;
constexpr std::size_t fit_samples = 33;

struct EndDirections {
  Vec3 start = Vec3::Zero();  // unit, into the curve
  Vec3 end = Vec3::Zero();
};

EndDirections end_directions(const RationalCubic& curve) {
  const NetworkCurve alone{{}, no_index, no_index, {curve}};
  return {alone.direction_from_start(), alone.direction_from_end()};
}

std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

class HandleFit {
 public:
  HandleFit(const RationalCubic& exact, const EndDirections& directions)
      : exact_(exact), directions_(directions), start_(exact.points[0]), end_(exact.points[3]) {
    for (std::size_t i = 0; i < fit_samples; ++i) {
      const double t = static_cast<double>(i) / (fit_samples - 1);
      samples_[i] = exact.at(t);
      parameters_[i] = t;
    }
  }

  RationalCubic run() {
    RationalCubic cubic = least_squares();
    for (int round = 0; round < fit_rounds; ++round) {
      move_to_foot_points(cubic);
      cubic = least_squares();
    }
    move_to_foot_points(cubic);
    return cubic;
  }

  void measure(const RationalCubic& cubic, const Camera& camera, FittedCurve& fitted) const {
    for (std::size_t i = 0; i < fit_samples; ++i) {
      const Vec3 point = cubic.at(parameters_[i]);
      fitted.error = std::max(fitted.error, (point - samples_[i]).norm());
      fitted.distance = std::max(fitted.distance, (camera.project(point) - camera.project(samples_[i])).norm());
    }
  }

 private:
  /// Handle lengths for the parameters so far.
  RationalCubic least_squares() const {
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
    Vec2 right = Vec2::Zero();
    for (std::size_t i = 0; i < fit_samples; ++i) {
      const std::array<double, 4> b = bernstein(parameters_[i]);
      const Vec3 rest = samples_[i] - (b[0] + b[1]) * start_ - (b[2] + b[3]) * end_;
      Eigen::Matrix<double, 3, 2> columns;
      columns << b[1] * directions_.start, b[2] * directions_.end;
      matrix += columns.transpose() * columns;
      right += columns.transpose() * rest;
    }
    Vec2 lengths = matrix.fullPivLu().solve(right);
    // Handles that would turn back say that the samples are nearly on a line.
    const double third = (end_ - start_).norm() / 3;
    for (int i = 0; i < 2; ++i) {
      if (!(lengths[i] > 0)) lengths[i] = third;
    }
    return {{start_, start_ + lengths[0] * directions_.start, end_ + lengths[1] * directions_.end, end_}};
  }

  void move_to_foot_points(const RationalCubic& cubic) {
    for (std::size_t i = 1; i + 1 < fit_samples; ++i) {
      double& t = parameters_[i];
      const Vec3 away = cubic.at(t) - samples_[i];
      const Vec3 first = cubic.derivative(t);
      const double s = 1 - t;
      const auto& p = cubic.points;
      const Vec3 second = 6 * (s * (p[2] - 2 * p[1] + p[0]) + t * (p[3] - 2 * p[2] + p[1]));
      const double slope = first.squaredNorm() + away.dot(second);
      if (slope > 0) t = std::clamp(t - away.dot(first) / slope, 0.0, 1.0);
    }
  }

  const RationalCubic& exact_;
  EndDirections directions_;
  Vec3 start_, end_;
  std::array<Vec3, fit_samples> samples_;
  std::array<double, fit_samples> parameters_{};
};

/// What has the same coordinate at all points of the exact curve keeps it bit by bit.
void keep_planes(const RationalCubic& exact, RationalCubic& cubic) {
  for (int k = 0; k < 3; ++k) {
    const double value = exact.points[0][k];
    const bool flat = std::ranges::all_of(exact.points, [&](const Vec3& point) { return point[k] == value; });
    if (!flat) continue;
    for (Vec3& point : cubic.points) point[k] = value;
  }
}

RationalCubic fitted_once(const RationalCubic& exact, const EndDirections& directions, const Camera& camera,
                          FittedCurve& fitted) {
  HandleFit fit(exact, directions);
  RationalCubic cubic = fit.run();
  keep_planes(exact, cubic);
  fit.measure(cubic, camera, fitted);
  return cubic;
}

}  // namespace

FittedCurve fit_polynomial(const RationalCubic& exact, const Camera& camera, double most_distance, double most_error) {
  if (exact.is_polynomial()) {
    FittedCurve same;
    same.pieces = {exact};
    same.pieces[0].weights = {1, 1, 1, 1};
    return same;
  }
  const EndDirections directions = end_directions(exact);
  FittedCurve one;
  one.pieces = {fitted_once(exact, directions, camera, one)};
  if (one.distance <= most_distance || one.error <= most_error) return one;
  auto [first, second] = exact.split(0.5);
  keep_planes(exact, first);
  keep_planes(exact, second);
  const Vec3 along = exact.derivative(0.5).normalized();
  FittedCurve two;
  two.pieces = {fitted_once(first, {directions.start, -along}, camera, two),
                fitted_once(second, {along, directions.end}, camera, two)};
  return two;
}

}  // namespace croquis
