// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/hole_filling/analysis/box_search.h"
#include "croquis/base/stage_key.h"
#include "croquis/geometry/mesh_part.h"
#include "croquis/hole_filling/fill_holes.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/hole_filling/hole_site.h"

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

/// The jobs for what holes have become. Where several meet in one rim the first one's settings count.
std::vector<FillJob> moved_jobs(const TrimmedScan& trimmed, const std::vector<FillJob>& jobs);

/// What became of the scan's holes, from what became of the rims: failed where any of a hole's rims stays open, filled
/// by "trimmed" where nothing was left of it.
/// @param outcomes  per rim
/// @param is_chosen per hole
std::vector<HoleOutcome> outcomes_before_trimming(const TrimmedScan& trimmed, const std::vector<HoleOutcome>& outcomes,
                                                  const std::vector<bool>& is_chosen);

/// The scan's own numbers for what is left of it after trimming, so that what was made for one hole is found again
/// after others have been trimmed: numbers of vertices and holes change then, but not what lies around it.
class ScanNumbers {
 public:
  /// Keeps references. Linear in what was removed, n log n at most.
  /// @param trimmed null: nothing was removed. @param analysis of the mesh that patches are made for
  ScanNumbers(const PolyMesh& scan, const TrimmedScan* trimmed, const HoleAnalysis& analysis, std::string scan_key);

  /// All that methods may look at: the scan, the site's rims, what trimming has removed near them and which rims are
  /// there. Methods look two diameters far at most: fits and probes less, and cubes that go farther don't close.
  void add_surroundings(const HoleSite& site, StageKey& key) const;

  /// What trimming has removed where the patch lies.
  void add_removed(const HolePatch& patch, StageKey& key) const;

  /// A patch in the scan's numbers: corners from #V of the scan on are its points. It has no holes, and each rim that
  /// it arrives at is named by its first two vertices.
  HolePatch in_scan(HolePatch patch) const;

  /// The patch that one in the scan's numbers is in the mesh, for these holes.
  HolePatch in_mesh(HolePatch patch, const std::vector<Index>& holes) const;

 private:
  void add_removed(const Box& box, StageKey& key) const;
  Index scan_vertex(Index vertex) const { return trimmed_ == nullptr ? vertex : trimmed_->part.vertices[vertex]; }
  Index mesh_vertex(Index vertex) const;
  const PolyMesh& mesh() const { return trimmed_ == nullptr ? scan_ : trimmed_->part.mesh; }

  const PolyMesh& scan_;
  const TrimmedScan* trimmed_;
  const HoleAnalysis& analysis_;
  std::string scan_key_;
  std::vector<Index> removed_;                           ///< faces of the scan, ascending
  BoxSearch<std::function<Box(Index)>> removed_search_;  ///< of their places in that list
  std::vector<Box> rim_boxes_;                           ///< per hole of the analysis
};

}  // namespace croquis::hole_filling
