// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// The triangulation of least area whose triangles meet neither the surface nor one another where they shouldn't:
/// triangles that do are forbidden and the search is repeated, 25 times for long rims and up to 300 times for short
/// ones.
///
/// A triangulation lies within the convex hull of its rim, so the surface is looked at there alone.
/// @return triangles of the site's polygon; nothing for more than 300 points, or when none was found
/// @throws Cancelled
std::optional<std::vector<std::array<Index, 3>>> avoiding_triangulation(const HoleSite& site, Progress& progress);

}  // namespace croquis::hole_filling
