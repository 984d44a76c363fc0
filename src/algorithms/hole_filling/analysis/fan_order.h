// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// One of several fans of triangles that meet in a vertex alone.
struct Petal {
  Vec3 first;   ///< from the vertex along the rim edge that leaves it: the fan lies to its left
  Vec3 last;    ///< from the vertex along the rim edge that arrives, backwards: the fan lies to its right
  Vec3 normal;  ///< of the fan, any length
};

/// For each petal the next one counter-clockwise, whose `first` bounds the same gap as its `last`; nothing when the
/// petals don't lie around the vertex one after another, seen along their mean normal.
std::vector<std::size_t> petal_across_gap(std::span<const Petal> petals);

}  // namespace croquis::hole_filling
