// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// Cosine of a triangle's smallest angle, which lies opposite to its shortest side: 1/2 to 1, and 1 where two corners
/// are the same.
inline double sharpest_cosine(const Vec3& a, const Vec3& b, const Vec3& c) {
  std::array<double, 3> square{(b - c).squaredNorm(), (c - a).squaredNorm(), (a - b).squaredNorm()};
  std::sort(square.begin(), square.end());
  const double sides = std::sqrt(square[1] * square[2]);
  return sides > 0 ? (square[1] + square[2] - square[0]) / (2 * sides) : 1;
}

}  // namespace croquis::silhouette
