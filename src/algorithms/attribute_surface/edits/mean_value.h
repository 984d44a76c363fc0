// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Weights of a polygon's corners, with the sum 1, whose mean is the place: smooth inside, linear along the sides.
/// Source: Floater 2003, "Mean value coordinates", equation (2.1).
/// @param polygon at least 3 corners, in either direction, convex or not
std::vector<double> mean_value_weights(std::span<const Vec2> polygon, const Vec2& place);

}  // namespace croquis
