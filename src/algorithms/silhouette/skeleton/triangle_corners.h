// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// Corners 0, 1, 2 of a triangle, counter-clockwise and clockwise.
constexpr Index next(Index corner) { return corner == 2 ? 0 : corner + 1; }
constexpr Index previous(Index corner) { return corner == 0 ? 2 : corner - 1; }

/// The corner of a triangle opposite to the edge that it shares with a neighbour.
/// @param neighbours per triangle, across the edge opposite to each corner
inline Index corner_across(const std::vector<std::array<Index, 3>>& neighbours, Index triangle, Index neighbour) {
  const std::array<Index, 3>& around = neighbours[triangle];
  return static_cast<Index>(std::find(around.begin(), around.end(), neighbour) - around.begin());
}

}  // namespace croquis::silhouette
