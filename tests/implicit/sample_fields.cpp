// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/sample_fields.h"

#include <algorithm>
#include <cmath>

namespace croquis::test {

double sphere_at(const Vec3& p, const Vec3& centre, double radius) { return (p - centre).norm() - radius; }

double torus_at(const Vec3& p, double radius, double tube) {
  return std::hypot(std::hypot(p.x(), p.y()) - radius, p.z()) - tube;
}

double ellipsoid_at(const Vec3& p, const Vec3& half_axes) {
  const double k = p.cwiseQuotient(half_axes).norm();
  const double slope = p.cwiseQuotient(half_axes.cwiseAbs2()).norm();
  return slope > 0 ? k * (k - 1) / slope : -half_axes.minCoeff();
}

double pierced_shell_at(const Vec3& p, double thickness) {
  const double shell = std::abs(p.norm() - 1) - thickness / 2;
  return std::max(shell, 0.4 - std::hypot(p.x(), p.y()));
}

implicit::PolygonizerOptions within(double reach, double cell, int seed_reach) {
  implicit::PolygonizerOptions options;
  options.cell = cell;
  options.bounds = {Vec3::Constant(-reach), Vec3::Constant(reach)};
  options.seed_reach = seed_reach;
  return options;
}

}  // namespace croquis::test
