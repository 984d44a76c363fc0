// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "croquis/geometry/vector.h"

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

}  // namespace croquis
