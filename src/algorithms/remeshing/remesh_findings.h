// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/remeshing/remesh_room.h"
#include "algorithms/remeshing/remesh_topology.h"
#include "croquis/remeshing/remesh.h"

namespace croquis::remeshing {

/// What a piece has lost.
struct PieceLosses {
  std::size_t piece = 0;
  bool retried = false;  ///< with smaller cubes, which didn't repair all
  std::size_t lost_points = 0;
  SurfaceTopology made;
  std::optional<SurfaceTopology> wanted;  ///< where it came out otherwise
  std::size_t loose = 0;                  ///< vertices that are left farther than half a cell off the scan
  Vec3 loose_at = Vec3::Zero();           ///< one of these
  RoomChange room;
  std::optional<SurfaceTopology> implied;  ///< where what was made has other parts or handles
  std::size_t together = 1;                ///< pieces that one solid was made of
  Vec3 at = Vec3::Zero();                  ///< a place where something is wrong
};

/// A piece that was left out, since what was made of it doesn't represent it.
struct RefusedPiece {
  std::size_t piece = 0;
  double lost_share = 0;         ///< of the piece's area; 0 where that isn't the reason
  std::size_t other = no_piece;  ///< that it crosses
  Vec3 at = Vec3::Zero();

  static constexpr auto no_piece = static_cast<std::size_t>(-1);
};

/// What isn't in the result itself.
struct RemeshLosses {
  std::size_t pieces = 0;    ///< without a surface
  std::size_t left_out = 0;  ///< as asked for
  double cell = 1;           ///< as RemeshOptions has it
  std::vector<PieceLosses> parts;
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
