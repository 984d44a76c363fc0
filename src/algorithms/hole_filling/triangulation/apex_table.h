// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// The triangles of a polygon's triangulation, each from the chord that it was chosen for to its apex and on to the
/// chords behind.
/// @param size of the polygon
/// @param apex_of the point between i and k that the triangle on the chord (i, k) has
template <typename ApexOf>
std::vector<std::array<Index, 3>> triangles_of_apexes(std::size_t size, ApexOf&& apex_of) {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::pair<std::size_t, std::size_t>> pending = {{0, size - 1}};
  while (!pending.empty()) {
    const auto [i, k] = pending.back();
    pending.pop_back();
    if (k - i < 2) continue;
    const std::size_t j = apex_of(i, k);
    triangles.push_back({static_cast<Index>(i), static_cast<Index>(j), static_cast<Index>(k)});
    pending.emplace_back(i, j);
    pending.emplace_back(j, k);
  }
  return triangles;
}

}  // namespace croquis::hole_filling
