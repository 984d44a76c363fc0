// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "algorithms/hole_filling/fairing/cgal_patch.h"

namespace croquis::hole_filling {

/// Cuts the triangles of a patch without new vertices, and flips them, until their edges are `coarseness` times as long
/// as those of its rim; farther inside lengths are interpolated between those of the rim. Nothing is faired:
/// new vertices lie in the triangles given.
/// @param input its density is left out of account
/// @return nothing when triangles share edges as no surface does
std::optional<FairingResult> refine_evenly(const FairingInput& input, double coarseness);

}  // namespace croquis::hole_filling
