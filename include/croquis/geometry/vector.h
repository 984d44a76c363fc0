// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

#include <Eigen/Core>

namespace croquis {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

/// Index of a vertex, face, corner, stroke …; which one is said by its name.
using Index = std::uint32_t;
inline constexpr Index no_index = ~Index{0};

/// z of the cross product of two plane vectors: positive when b lies to the left of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Angle between two directions of any length in radians, 0..pi; exact for small angles too, where acos is not.
inline double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// The direction of v, or zero where v has none.
inline Vec3 unit_or_zero(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

/// A quarter turn to the left.
inline Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }

}  // namespace croquis
