// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/mesh_part.h"
#include "croquis/hole_filling/fill_jobs.h"

namespace croquis::hole_filling {

/// A scan without the faces along some of its rims.
struct TrimmedScan {
  MeshPart part;                         ///< what is left, in its order
  HoleAnalysis analysis;                 ///< of that
  std::vector<std::vector<Index>> rims;  ///< per hole of the scan those that it became, ascending; trimming joins rims
                                         ///< that come near each other, may divide one, or leave nothing of a piece
};

/// Removes rings of faces around holes: a ring is all faces that touch the rim, and with the last one go the faces that
/// would be left hanging by one edge. Faces that touch the rim of a hole with no rings stay, and so do vertices that
/// never had a face. Linear per ring.
/// @param rings 0..3 per hole, not all 0
/// @throws Error (E_PARAMETER) when no face would be left
/// @throws Cancelled
TrimmedScan trim_rims(const PolyMesh& mesh, const HoleAnalysis& analysis, const std::vector<int>& rings,
                      const HoleAnalysisOptions& options, Progress& progress);

/// The jobs for what holes have become. Where several meet in one rim the first one's wish counts.
std::vector<FillJob> moved_jobs(const TrimmedScan& trimmed, const std::vector<FillJob>& jobs);

/// What became of the scan's holes, from what became of the rims: failed where any of a hole's rims stays open, filled
/// by "trimmed" where nothing was left of it.
/// @param outcomes  per rim
/// @param is_chosen per hole
std::vector<HoleOutcome> outcomes_before_trimming(const TrimmedScan& trimmed, const std::vector<HoleOutcome>& outcomes,
                                                  const std::vector<bool>& is_chosen);

}  // namespace croquis::hole_filling
