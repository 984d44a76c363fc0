// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/perspective/patches/face_star.h"

namespace croquis {

/// The star of least energy (patch_fairing.h) near another one: of the middle, the tangent plane there and all handles
/// of the spokes.
StarShape fair_star(const std::vector<FaceSide>& sides, const StarShape& start, const PatchOptions& options);

}  // namespace croquis
