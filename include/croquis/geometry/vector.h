// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// A quarter turn to the left.
inline Vec2 left_of(const Vec2& direction) { return {-direction.y(), direction.x()}; }

}  // namespace croquis
