// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algorithms/hole_filling/rim_trimming.h"
#include "croquis/hole_filling/hole_choice.h"

namespace croquis::hole_filling {

/// Makes a patch for each job, by the first of its methods whose patch is sound.
///
/// In rounds: every open job makes a patch by its next method, on several threads, then all are verified together; of
/// two that meet the first one is taken. The same for any number of threads, and with any cache.
/// @param numbers of the scan that the mesh is left of, for the cache of the options
/// @return the jobs with their patches and outcomes, by their lowest holes; those that waited in vain are left out
/// @throws Cancelled
std::vector<FillJob> make_patches(const PolyMesh& mesh, const HoleAnalysis& analysis, std::vector<FillJob> jobs,
                                  const FillOptions& options, const ScanNumbers& numbers, Progress& progress);

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
