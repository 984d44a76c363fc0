// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// A place of a Bézier curve of any degree, without allocating (nested multiplication of the Bernstein form).
/// @pre control is not empty; t in 0..1
Vec3 bezier_at(std::span<const Vec3> control, double t);

/// Control points of the derivative: one less.
std::vector<Vec3> bezier_derivative(std::span<const Vec3> control);

}  // namespace croquis
