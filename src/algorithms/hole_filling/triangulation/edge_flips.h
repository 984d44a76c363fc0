// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/rim_triangulation.h"

namespace croquis::hole_filling {

/// Flips inner edges while that lowers the sum of `triangle_cost`; triangles without area and blocked edges go first.
/// At most 20 flips per triangle.
/// @return whether no triangle without area and no blocked edge is left
bool flip_to_less_area(const RimPolygon& rims, std::vector<std::array<Index, 3>>& triangles, Progress& progress);

}  // namespace croquis::hole_filling
