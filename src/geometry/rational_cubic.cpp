// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/rational_cubic.h"

#include <algorithm>

namespace croquis {
namespace {

/// A weighted point: w P and w.
using Weighted = Eigen::Vector4d;

std::array<Weighted, 4> weighted_points(const RationalCubic& cubic) {
  std::array<Weighted, 4> result;
  for (std::size_t i = 0; i < 4; ++i) result[i] << cubic.weights[i] * cubic.points[i], cubic.weights[i];
  return result;
}

RationalCubic cubic_of(const std::array<Weighted, 4>& points) {
  RationalCubic result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.points[i] = points[i].head<3>() / points[i].w();
    result.weights[i] = points[i].w();
  }
  return result;
}

}  // namespace

bool RationalCubic::is_polynomial() const {
  return std::ranges::all_of(weights, [&](double weight) { return weight == weights[0]; });
}

Vec3 RationalCubic::at(double t) const {
  if (t == 0) return points[0];
  if (t == 1) return points[3];
  const double s = 1 - t;
  const auto p = weighted_points(*this);
  const Weighted sum = s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
  return sum.head<3>() / sum.w();
}

Vec3 RationalCubic::derivative(double t) const {
  const double s = 1 - t;
  const auto p = weighted_points(*this);
  const Weighted value = s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
  const Weighted slope = 3 * (s * s * (p[1] - p[0]) + 2 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
  return (slope.head<3>() - slope.w() / value.w() * value.head<3>()) / value.w();
}

RationalCubic RationalCubic::reversed() const {
  RationalCubic result = *this;
  std::ranges::reverse(result.points);
  std::ranges::reverse(result.weights);
  return result;
}

std::pair<RationalCubic, RationalCubic> RationalCubic::split(double t) const {
  const auto p = weighted_points(*this);
  const auto between = [t](const Weighted& a, const Weighted& b) -> Weighted { return (1 - t) * a + t * b; };
  const Weighted p01 = between(p[0], p[1]), p12 = between(p[1], p[2]), p23 = between(p[2], p[3]);
  const Weighted p012 = between(p01, p12), p123 = between(p12, p23);
  const Weighted middle = between(p012, p123);
  auto halves = std::pair(cubic_of({p[0], p01, p012, middle}), cubic_of({middle, p123, p23, p[3]}));
  halves.first.points[0] = points[0];  // multiplied and divided by its weight it could be a bit off
  halves.second.points[3] = points[3];
  return halves;
}

RationalCubic straight_cubic(const Vec3& from, const Vec3& to) {
  const Vec3 step = (to - from) / 3;
  return {{from, from + step, to - step, to}};
}

}  // namespace croquis
