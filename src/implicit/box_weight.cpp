// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/box_weight.h"

namespace croquis::implicit {
namespace {

/// The three factors 4 (P - S)(T - P)/(T - S)^2 of (7a); all 0 when P isn't inside.
Vec3 factors(const Box& box, const Vec3& point) {
  const Eigen::Array3d below = (point - box.low).array();
  const Eigen::Array3d above = (box.high - point).array();
  if ((below <= 0).any() || (above <= 0).any()) return Vec3::Zero();
  return (4 * below * above / box.size().array().square()).matrix();
}

}  // namespace

Box bounds(std::span<const Vec3> points) {
  if (points.empty()) return {};
  Box box = {points[0], points[0]};
  for (const Vec3& point : points) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

BoxWeight box_weight(const Box& box, const Vec3& point) {
  const Vec3 f = factors(box, point);
  const double product = f.prod();
  if (!(product > 0)) return {};
  // W(d) = 1 - W(1 - d) with 1 - d = product: exact down to the faces, where W(d) would cancel.
  const double value = product * product * product * (10 + product * (6 * product - 15));
  const Vec3 slopes = (4 * (box.low + box.high - 2 * point).array() / box.size().array().square()).matrix();
  const Vec3 gradient(slopes.x() * f.y() * f.z(), f.x() * slopes.y() * f.z(), f.x() * f.y() * slopes.z());
  return {value, 30 * product * product * (1 - product) * (1 - product) * gradient};
}

}  // namespace croquis::implicit
