// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/cubic_join.h"

#include <algorithm>

namespace croquis::silhouette {
namespace {

// Points that a curve is measured by before it is sampled evenly.
constexpr int dense_points = 64;
// Ends that turn away from each other further than this are given no longer handles.
constexpr double least_facing = -0.3;

}  // namespace

std::array<Vec2, 4> completion_curve(const Vec2& a, const Vec2& tangent_a, const Vec2& b, const Vec2& tangent_b) {
  const double distance = (b - a).norm();
  const Vec2 across = distance > 0 ? Vec2((b - a) / distance) : Vec2(1, 0);
  const double facing = 0.5 * (tangent_a.dot(across) - tangent_b.dot(across));
  const double handle = 2.0 / 3.0 * distance / (1 + std::max(facing, least_facing));
  return {a, a + handle * tangent_a, b + handle * tangent_b, b};
}

Vec2 bezier_at(const std::array<Vec2, 4>& p, double t) {
  const double s = 1 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

Points bezier_points(const std::array<Vec2, 4>& curve, double spacing) {
  Points dense;
  for (int i = 0; i <= dense_points; ++i) dense.push_back(bezier_at(curve, static_cast<double>(i) / dense_points));
  const double length = croquis::length(dense, false);
  Points points;
  for (const double parameter : even_parameters(dense, false, std::min(spacing, length / 4))) {
    points.push_back(point_at(dense, parameter));
  }
  return points;
}

}  // namespace croquis::silhouette
