// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// What edges weigh beside the area: decides where areas are equal, as on flat rims, and only there. More would fold
/// flat patches over where that shortens edges; less would be lost in the rounding of areas.
inline constexpr double edge_weight = 1e-10;

/// Twice the area over the squared longest edge: flatter triangles count as impossible.
inline constexpr double least_flatness = 1e-9;

/// Twice the area of a triangle plus a trace of its squared edges; infinite for one without area.
inline double triangle_cost(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double twice_area = ab.cross(ac).norm();
  const double squares[3] = {ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()};
  if (!(twice_area > least_flatness * std::max({squares[0], squares[1], squares[2]})))
    return std::numeric_limits<double>::infinity();
  return twice_area + edge_weight * (squares[0] + squares[1] + squares[2]);
}

inline double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).norm() / 2; }

}  // namespace croquis::hole_filling
