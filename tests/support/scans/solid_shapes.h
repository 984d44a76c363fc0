// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "croquis/geometry/vector.h"

/// Signed distances of simple solids, negative inside, and how they are put together.
namespace croquis::test {

/// The union of two solids, blended where both are nearer than `k`.
inline double blend(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * k / 4;
}

inline double carve(double solid, double tool, double k) { return -blend(-solid, tool, k); }

inline double ball(const Vec3& p, const Vec3& centre, double radius) { return (p - centre).norm() - radius; }

/// Not the distance, but with a gradient near 1 at the surface.
inline double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii) {
  const Vec3 scaled = (p - centre).cwiseQuotient(radii);
  const double slope = scaled.cwiseQuotient(radii).norm();
  return slope > 0 ? scaled.norm() * (scaled.norm() - 1) / slope : -radii.minCoeff();
}

/// A limb: a ball that moves from a to b while its radius changes.
inline double limb(const Vec3& p, const Vec3& a, const Vec3& b, double radius_a, double radius_b) {
  const Vec3 along = b - a;
  const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - a - t * along).norm() - radius_a - t * (radius_b - radius_a);
}

inline double box(const Vec3& p, const Vec3& centre, const Vec3& half_size) {
  const Vec3 q = (p - centre).cwiseAbs() - half_size;
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
}

/// Along `axis`, with flat ends.
inline double cylinder(const Vec3& p, const Vec3& centre, int axis, double radius, double half_length) {
  Vec3 q = p - centre;
  const double end = std::abs(q[axis]) - half_length;
  q[axis] = 0;
  const double side = q.norm() - radius;
  return std::min(std::max(side, end), 0.0) + std::hypot(std::max(side, 0.0), std::max(end, 0.0));
}

}  // namespace croquis::test
