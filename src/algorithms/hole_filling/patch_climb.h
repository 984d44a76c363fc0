// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/hole_filling/scan_numbers.h"
#include "croquis/hole_filling/fill_jobs.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// What became of a job.
struct ClimbedJob {
  std::vector<Index> holes;        ///< ascending
  std::optional<HolePatch> patch;  ///< verified; none when no method had a sound one
  PatchVerdict verdict;
  std::string method;  ///< of the patch
  std::string
      first_fault;  ///< what was wrong with the first patch that was tried, empty when one of its kind was taken
};

/// Makes a patch for each job, by the first of its methods whose patch is sound.
///
/// In rounds: every open job makes a patch by its next method, on several threads, then all are verified together; of
/// two that meet the first one is taken. The same for any number of threads, and with any cache.
/// @param numbers of the scan that the mesh is left of, for the cache of the options
/// @throws Cancelled
std::vector<ClimbedJob> climb(const PolyMesh& mesh, const HoleAnalysis& analysis, std::vector<FillJob> jobs,
                              const FillOptions& options, const ScanNumbers& numbers, Progress& progress);

}  // namespace croquis::hole_filling
