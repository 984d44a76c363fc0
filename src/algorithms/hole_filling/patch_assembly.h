// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// The mesh with the patches' vertices and faces behind its own, in the patches' order; all channels continued.
/// @param mark_patches whether the face channel "patch_id" tells each patch's number
PolyMesh append_patches(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const HolePatch> patches,
                        bool mark_patches);

}  // namespace croquis::hole_filling
