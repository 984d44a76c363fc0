// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// The greatest distance of two of the points, exact; 0 for fewer than two.
///
/// Pairs of boxes of a tree are followed only where they could hold a longer one than is known: close to n log n on
/// rims, circles included.
double greatest_distance(std::span<const Vec3> points);

}  // namespace croquis::hole_filling
