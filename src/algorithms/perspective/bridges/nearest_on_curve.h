// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/rational_cubic.h"

namespace croquis {

/// The place of a curve of one or more pieces that is nearest to a point: on the curve to rounding, nearest to about
/// 1e-8 of its length.
Vec3 nearest_on_curve(const std::vector<RationalCubic>& pieces, const Vec3& point);

}  // namespace croquis
