// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/rim_triangulation.h"

namespace croquis::hole_filling {

/// What a band has least of.
enum class BandCost {
  Area,   ///< for bands that are to be curved: the start of a smooth one
  Length  ///< squared lengths of the edges between both sides: never twisted where that can be avoided
};

/// A band of triangles between two rims, each with an edge on one of them and the third corner on the other, no new
/// vertices. Of all bands with the shortest edge between the rims the one of least cost, by dynamic programming (time
/// and memory n m); for rims with n m above 4 million by going on with the shorter edge each time (linear).
/// @param rims two loops @return triangles of its points, or nothing when all have blocked edges or no area
/// @throws Cancelled
std::optional<std::vector<std::array<Index, 3>>> band_triangulation(const RimPolygon& rims, BandCost cost,
                                                                    Progress& progress);

/// The same between the two sides of one rim, from one end to the other: the rim is zipped. Its ends are the two points
/// farthest from each other.
std::optional<std::vector<std::array<Index, 3>>> zip_triangulation(const RimPolygon& rim, BandCost cost,
                                                                   Progress& progress);

}  // namespace croquis::hole_filling
