// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/hole_filling/remeshing/remesh_topology.h"
#include "croquis/hole_filling/remesh.h"

namespace croquis::hole_filling {

/// What a piece has lost.
struct PieceLosses {
  std::size_t piece = 0;
  bool retried = false;  ///< with smaller cubes, which didn't mend all
  std::size_t lost_points = 0;
  SurfaceTopology made;
  std::optional<SurfaceTopology> wanted;  ///< where it came out otherwise
  Vec3 at = Vec3::Zero();                 ///< a place where something is wrong
};

/// What isn't in the result itself.
struct RemeshLosses {
  std::size_t pieces = 0;    ///< without a surface
  std::size_t left_out = 0;  ///< as asked for
  double cell = 1;           ///< as RemeshOptions has it
  std::vector<PieceLosses> parts;
};

/// The analysis' findings; then holes left as OUTER, filled by patches after all, failed, or of low confidence; pieces
/// of which nothing came out; and what the checks found.
/// @param mesh the one given
Findings remesh_findings(const PolyMesh& mesh, const RemeshResult& result, const RemeshLosses& losses);

}  // namespace croquis::hole_filling
