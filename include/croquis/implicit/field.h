// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "croquis/geometry/vector.h"

/// Surfaces as the zero set of a function of space: fields from points and normals, and their polygons.
///
/// Everywhere in this module a field is negative inside, positive outside, and zero on the surface; near the surface it
/// is about the signed distance.
namespace croquis::implicit {

/// Values, and gradients where wanted, of a scalar function at many points at once, so that its loops vectorise.
///
/// Points and values have the same size; gradients have it too, or none: then they aren't wanted. NaN as value: the
/// function is not defined there. Called from several threads at once; the answer for a point depends on that point
/// alone.
using Field = std::function<void(std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients)>;

}  // namespace croquis::implicit
