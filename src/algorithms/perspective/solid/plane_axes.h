// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/rational_cubic.h"

namespace croquis {

/// Two axes of a plane, right-handed with its normal; world axes where it is at right angles to one, so that nothing is
/// rounded.
/// @param normal unit
inline std::array<Vec3, 2> plane_axes(const Vec3& normal) {
  Vec3 u = normal.unitOrthogonal();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) == 1) u = Vec3::Unit((axis + 1) % 3);
  }
  return {u, normal.cross(u)};
}

/// The coordinate along an axis that all points of the cubics have, bit for bit; null where they differ.
/// @param cubics at least one
inline const double* common_level(std::span<const RationalCubic> cubics, int axis) {
  const double& level = cubics.front().points[0][axis];
  for (const RationalCubic& cubic : cubics) {
    for (const Vec3& point : cubic.points) {
      if (point[axis] != level) return nullptr;
    }
  }
  return &level;
}

/// (u, v) of a patch a part t of the way along a side, 0..3.
inline std::pair<double, double> place_on_side(std::size_t side, double t) {
  switch (side) {
    case 0: return {t, 0};
    case 1: return {1, t};
    case 2: return {1 - t, 1};
    default: return {0, 1 - t};
  }
}

}  // namespace croquis
