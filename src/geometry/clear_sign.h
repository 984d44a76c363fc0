// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "croquis/geometry/vector.h"

/// Fast signs in floating point that are certain where they are given, so that exact predicates, ten times as slow,
/// are needed for the few doubtful cases only.
namespace croquis {

/// How clear the sign of a sum of products must be, relative to the product of the lengths multiplied. Rounding of
/// differences and products stays below 60 × 2^-53 of it; this leaves a wide margin.
inline constexpr double sign_margin = 1e-12;

/// Under this products may have lost their precision to underflow.
inline constexpr double smallest_product = 1e-200;

/// Beyond this squared length products may overflow: nothing is clear then.
inline constexpr double largest_square = 1e120;

/// Whether three points clearly span a triangle. @param longest its longest edge, squared, or more
inline bool clearly_has_area(const Vec3& a, const Vec3& b, const Vec3& c, double longest) {
  if (!(longest < largest_square)) return false;
  return Vec3(b - a).cross(Vec3(c - a)).cwiseAbs().maxCoeff() > sign_margin * longest + smallest_product;
}

inline double longest_edge_squared(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

}  // namespace croquis
