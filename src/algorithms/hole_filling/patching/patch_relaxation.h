// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "algorithms/hole_filling/patching/patch_editing.h"

namespace croquis::hole_filling {

/// Every vertex moves to the mean of the centroids of its triangles, weighted by how many triangles of the size wanted
/// there would fit into them, all at the same time. Where one size is wanted everywhere these weights are the areas
/// (Yoo 2005, eq. 9); by areas alone, vertices near short edges of a rim would drift off to the larger triangles behind
/// them and leave slender ones at the rim.
/// @param fixed #points, 1 where a vertex stays, as those of rims must
void relax(LoosePatch& patch, std::span<const std::uint8_t> fixed);

}  // namespace croquis::hole_filling
