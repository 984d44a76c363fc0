// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/edits/mean_value.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace croquis {
namespace {

constexpr double on_side = 1e-12;  // × the polygon's size: nearer places are on the side

/// tan of half the angle under which a side is seen, signed; from both ways to its ends.
double half_tangent(const Vec2& a, const Vec2& b) {
  const double sine = cross(a, b);
  const double product = a.norm() * b.norm();
  return sine / (product + a.dot(b));
}

}  // namespace

std::vector<double> mean_value_weights(std::span<const Vec2> polygon, const Vec2& place) {
  const std::size_t count = polygon.size();
  std::vector<double> weights(count, 0.0);
  double size = 0;
  for (const Vec2& corner : polygon) size = std::max(size, (corner - place).norm());
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const Vec2 a = polygon[i] - place;
    const Vec2 b = polygon[next] - place;
    if (a.norm() <= on_side * size || (a.dot(b) < 0 && std::abs(cross(a, b)) <= on_side * size * (b - a).norm())) {
      weights.assign(count, 0.0);
      const double whole = a.norm() + b.norm();
      weights[i] = whole > 0 ? b.norm() / whole : 1;
      weights[next] += 1 - weights[i];
      return weights;
    }
    if (b.norm() <= on_side * size) continue;  // the next side says so
    const double tangent = half_tangent(a, b);
    weights[i] += tangent / a.norm();
    weights[next] += tangent / b.norm();
    sum += tangent / a.norm() + tangent / b.norm();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace croquis
