// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Where a closed row of points is cut into sides.
struct RimCuts {
  std::vector<std::size_t> at;  ///< ascending
  std::vector<bool> is_corner;  ///< one for each: whether the row turns sharply there
};

/// @param corner radians: turns by more, beyond those of a circle of as many points, are corners
/// @param sides  3..12, or 0 for as many as the corners ask for; never more than there are points
RimCuts cut_rim(std::span<const Vec3> loop, double corner, std::size_t sides);

}  // namespace croquis
