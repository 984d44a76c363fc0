// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/implicit/local_fit.h"

namespace croquis::test {

/// Uniform in [-1, 1]^3.
std::vector<Vec3> random_points(std::size_t count, std::uint64_t seed);

/// Evenly spread on a spiral (Fibonacci lattice), with normals outwards. Another count shares hardly any point.
implicit::Constraints sphere_points(std::size_t count, const Vec3& centre, double radius);

/// Half axes along x, y, z; about the origin.
implicit::Constraints ellipsoid_points(std::size_t count, const Vec3& half_axes);

/// Evenly spread; around z about the origin.
implicit::Constraints torus_points(std::size_t count, double radius, double tube);

}  // namespace croquis::test
