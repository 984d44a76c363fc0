// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/rim_trimming.h"
#include "croquis/base/stage_key.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// What a method made, in the scan's numbers; kept as it is, so that failures aren't tried again either.
struct Attempt {
  std::optional<HolePatch> patch;                ///< corners from #V of the scan on are its points; without holes
  std::vector<std::array<Index, 2>> arrives_at;  ///< further rims, by their first two vertices
};

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

  Attempt in_scan(std::optional<HolePatch> patch) const;
  std::optional<HolePatch> in_mesh(const Attempt& attempt, const std::vector<Index>& holes) const;

 private:
  struct RemovedFace {
    Index face = 0;  ///< of the scan
    Eigen::AlignedBox3d box;
  };

  void find_removed();
  void add_removed(const Eigen::AlignedBox3d& box, StageKey& key) const;
  Index scan_vertex(Index vertex) const { return trimmed_ == nullptr ? vertex : trimmed_->part.vertices[vertex]; }
  Index mesh_vertex(Index vertex) const;
  Index mesh_vertex_count() const;
  std::array<Index, 2> name_of(const Hole& hole) const;

  const PolyMesh& scan_;
  const TrimmedScan* trimmed_;
  const HoleAnalysis& analysis_;
  std::string scan_key_;
  std::vector<RemovedFace> removed_;            ///< by their boxes' least x
  double widest_ = 0;                           ///< of their boxes, along x
  std::vector<Eigen::AlignedBox3d> rim_boxes_;  ///< per hole of the analysis
};

}  // namespace croquis::hole_filling
