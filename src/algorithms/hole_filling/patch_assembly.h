// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// The mesh with the patches' vertices and faces behind its own, in the patches' order; all channels continued.
/// @param mark_patches whether the face channel "patch_id" holds each patch's number, and the vertex channel
///        "confidence" how far the surface around backs each new vertex; one of that name and a floating type
///        keeps its values
/// @param threads 0: as many as the machine has. The result is the same for any
PolyMesh append_patches(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const HolePatch> patches,
                        bool mark_patches, int threads);

/// The number that the first patch gets: 0, or one more than the highest of an earlier filling. Linear.
Index next_patch_number(const PolyMesh& mesh);

}  // namespace croquis::hole_filling
