// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "croquis/hole_filling/rim_triangulation.h"

namespace croquis::hole_filling {

/// The constrained Delaunay triangulation of the rims in the plane nearest to the first, inside the first and outside
/// the others; nothing when rims meet in that plane or don't run around one another as they should.
std::optional<std::vector<std::array<Index, 3>>> plane_triangulation(const RimPolygon& rims);

}  // namespace croquis::hole_filling
