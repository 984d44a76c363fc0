// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "croquis/geometry/attribute_network.h"

/// Networks of one face.
namespace croquis::test {

/// Corners around a rough circle, up and down as well; curves of degree 1 to 6 that swing in all directions.
/// @param sides 2 or more
AttributeNetwork random_loop(std::size_t sides, std::uint64_t seed);

/// A loop of the plane of random orientation, with the same kinds of curves.
AttributeNetwork flat_loop(std::size_t sides, std::uint64_t seed);

/// A polygon of straight sides in a circle, anywhere in space. Every third seed has the circle's middle outside.
AttributeNetwork cyclic_polygon(std::size_t sides, std::uint64_t seed);

/// A convex polygon of straight sides in no circle, anywhere in space.
AttributeNetwork convex_polygon(std::size_t sides, std::uint64_t seed);

AttributeNetwork leaf_loop();                   ///< two curves
AttributeNetwork wavy_star(std::size_t sides);  ///< corners in and out by turns, curves of degree 5 up and down
AttributeNetwork l_loop();                      ///< six straight sides around an L, strongly concave

/// Networks that strain numbers: control points that are repeated, sides of very different lengths, units of 1e-3 and
/// 1e4, far from the origin, a curve that goes there and back.
std::vector<AttributeNetwork> strained_loops();

/// random_loop for 2 to 12 sides and several seeds, with leaf, stars and strained ones.
std::vector<AttributeNetwork> all_loops();

/// Everything multiplied and then moved.
AttributeNetwork resized(const AttributeNetwork& network, double factor, const Vec3& move = Vec3::Zero());

}  // namespace croquis::test
