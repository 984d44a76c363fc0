// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/perspective/patches/face_star.h"

namespace croquis {

/// The star of least energy near another one: of the middle, the tangent plane there and all handles of the spokes.
/// The energy is the variation energy of the patches, and what their second derivatives differ by across the spokes.
/// Lengths count by themselves, so that the scaled and turned face gives the scaled and turned star.
StarShape fair_star(const std::vector<FaceSide>& sides, const StarShape& start, const PatchOptions& options);

}  // namespace croquis
