// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include <Eigen/Geometry>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

inline double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double squared = ab.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * ab).norm();
}

inline double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  const bool is_over = squared > 0 && normal.dot((b - a).cross(p - a)) >= 0 && normal.dot((c - b).cross(p - b)) >= 0 &&
                       normal.dot((a - c).cross(p - c)) >= 0;
  if (is_over) return std::abs(normal.dot(p - a)) / std::sqrt(squared);
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

/// To the nearest of some triangles: linear in their number.
inline double distance_to_triangles(const Vec3& p, std::span<const std::array<Vec3, 3>> triangles) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : triangles) least = std::min(least, distance_to_triangle(p, a, b, c));
  return least;
}

}  // namespace croquis::hole_filling
