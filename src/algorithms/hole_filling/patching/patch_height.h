// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/hole_filling/patching/patcher.h"

namespace croquis::hole_filling {

/// How far a patch rises over its hole: the greatest distance of its vertices, those of the rims too, from the plane
/// that is nearest to the widest of the rims. Model units.
double patch_height(const HoleSite& site, const HolePatch& patch);

/// Whether a patch rises farther than half the diameter of its widest rim, and 1.3 times as far as the one that
/// faired_patcher(1) makes, or as the rims themselves. Bands and patches with places or a bulge to follow never do:
/// what they are is wanted. Linear, unless it rises so far: then that other patch is made.
bool rises_too_far(const HoleSite& site, const HolePatch& patch, std::size_t most_triangles, Progress& progress);

}  // namespace croquis::hole_filling
