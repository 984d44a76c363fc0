// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/remeshing/comparison.h"
#include "algorithms/remeshing/union.h"
#include "croquis/remeshing/remesh.h"

namespace croquis::remeshing {

/// Where what was made of a piece isn't what it should be.
struct PieceFaults {
  std::size_t piece = 0;
  Vec3 at = Vec3::Zero();          ///< a place where something is wrong
  bool retried = false;            ///< with smaller cubes, which didn't repair all
  std::size_t lost_points = 0;     ///< without a surface
  std::size_t loose_vertices = 0;  ///< that are left farther than half a cell off the scan
  SurfaceTopology made;
  std::optional<ExpectedTopology> expected;  ///< where it came out otherwise
  ExtentChange change;
  std::size_t together = 1;  ///< pieces that one solid was made of
};

/// What isn't in the result itself.
struct RemeshLosses {
  std::size_t pieces = 0;    ///< without a surface
  std::size_t left_out = 0;  ///< as asked for
  double cell = 1;           ///< as RemeshOptions has it
  std::vector<PieceFaults> faults;
  std::vector<RefusedPiece> refused;
  std::vector<Index> far_holes;  ///< in which the result is far from the scan, ascending
  Vec3 far_at = Vec3::Zero();    ///< a place where it is, if there is any
};

/// The analysis' findings; then holes left as OUTER, filled by patches after all, failed, or of low confidence; pieces
/// of which nothing came out; and what the checks found.
/// @param mesh the one given
Findings remesh_findings(const PolyMesh& mesh, const RemeshResult& result, const RemeshLosses& losses);

/// @throws Error E_NOT_REMESHED (Category::Geometry), with all reasons, when nothing of the model is left
void require_faces(const PolyMesh& made, const RemeshLosses& losses);

}  // namespace croquis::remeshing
