// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/refined.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace croquis::test {

using namespace subdivision;

Refined refined(const PolyMesh& mesh, int levels, const Rules& rules) {
  Progress progress;
  const Cage cage = make_cage(mesh, rules).cage;
  Refined result{DooSabinPlan(cage, rules, levels, progress), {}};
  result.plan.positions(cage.positions, result.points);
  return result;
}

UniformRefined uniformly_refined(const PolyMesh& mesh, int levels, const UniformRules& rules) {
  Progress progress;
  const Cage cage = make_cage(mesh).cage;
  UniformRefined result{UniformPlan(cage, rules, levels, progress), {}};
  result.plan.positions(cage.positions, result.points);
  return result;
}

double greatest_gap(std::span<const Vec3> a, std::span<const Vec3> b) {
  double greatest = 0;
  for (const Vec3& point : a) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& other : b) nearest = std::min(nearest, (point - other).squaredNorm());
    greatest = std::max(greatest, nearest);
  }
  return std::sqrt(greatest);
}

double extent(std::span<const Vec3> points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return (high - low).norm();
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace croquis::test
