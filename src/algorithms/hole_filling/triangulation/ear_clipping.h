// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "croquis/hole_filling/rim_triangulation.h"

namespace croquis::hole_filling {

/// Cuts triangles off a closed polygon in space, the shortest new diagonal first; turns that the polygon's own plane
/// calls reflex come last. n log n. Shape isn't controlled: a fallback where no plane can be used.
/// @param order as for minimal_triangulation
std::optional<std::vector<std::array<Index, 3>>> clip_ears(const RimPolygon& rims, std::span<const Index> order);

}  // namespace croquis::hole_filling
