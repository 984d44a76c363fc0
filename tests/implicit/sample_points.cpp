// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/sample_points.h"

#include <cmath>

#include "support/random.h"

namespace croquis::test {

using implicit::Constraints;

std::vector<Vec3> random_points(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points(count);
  for (Vec3& point : points)
    for (int axis = 0; axis < 3; ++axis) point[axis] = random.between(-1, 1);
  return points;
}

Constraints sphere_points(std::size_t count, const Vec3& centre, double radius) {
  Constraints points;
  const double golden = M_PI * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < count; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
    const double turn = golden * static_cast<double>(i);
    const double ring = std::sqrt(1 - z * z);
    const Vec3 normal(ring * std::cos(turn), ring * std::sin(turn), z);
    points.positions.push_back(centre + radius * normal);
    points.gradients.push_back(normal);
  }
  return points;
}

Constraints ellipsoid_points(std::size_t count, const Vec3& half_axes) {
  Constraints points = sphere_points(count, Vec3::Zero(), 1);
  for (std::size_t i = 0; i < count; ++i) {
    points.gradients[i] = points.positions[i].cwiseQuotient(half_axes).normalized();
    points.positions[i] = points.positions[i].cwiseProduct(half_axes);
  }
  return points;
}

Constraints torus_points(std::size_t count, double radius, double tube) {
  Constraints points;
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  for (std::size_t i = 0; i < count; ++i) {
    // Rings further out are longer: the angle around the tube that has a fraction u of the area inside.
    const double u = 2 * M_PI * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    double v = u;
    for (int step = 0; step < 20; ++step) v = u - tube / radius * std::sin(v);
    const double turn = 2 * M_PI * golden * static_cast<double>(i);
    const Vec3 outward(std::cos(turn), std::sin(turn), 0);
    const Vec3 normal = std::cos(v) * outward + std::sin(v) * Vec3::UnitZ();
    points.positions.push_back(radius * outward + tube * normal);
    points.gradients.push_back(normal);
  }
  return points;
}

}  // namespace croquis::test
