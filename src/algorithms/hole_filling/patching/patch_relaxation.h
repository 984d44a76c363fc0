// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "algorithms/hole_filling/patching/patch_editing.h"

namespace croquis::hole_filling {

/// Every vertex moves to the mean of the centroids of its triangles, weighted by their areas, all at the same time
/// (Yoo 2005, eq. 9). What `smooth_towards_centroids` does for meshes, without looking for their boundary.
/// @param fixed #points, 1 where a vertex stays, as those of rims must
void relax(LoosePatch& patch, std::span<const std::uint8_t> fixed);

}  // namespace croquis::hole_filling
