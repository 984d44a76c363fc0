// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "algorithms/hole_filling/fairing/patch_editing.h"

namespace croquis::hole_filling {

/// Every vertex moves to the mean of the centroids of its triangles, all at the same time. They are weighted by their
/// areas (Yoo 2005, eq. 9) over the lengths that edges are to have there. Where one length is wanted everywhere that
/// changes nothing; by areas alone, vertices near short edges of a rim move to the larger triangles behind them
/// and leave slender ones at the rim, and by areas over squared lengths, which count triangles, they crowd there and
/// fold.
/// @param fixed #points, 1 where a vertex stays, as those of rims must
void relax(LoosePatch& patch, std::span<const std::uint8_t> fixed);

}  // namespace croquis::hole_filling
