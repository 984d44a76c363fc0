// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "algorithms/remeshing/views/view_seams.h"
#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/remeshing/remesh.h"

namespace croquis::remeshing {

/// A part of the mesh that gets a function of its own: a component, or several that share vertices or a hole to fill,
/// or that are views of one thing.
struct RemeshPiece {
  std::vector<Index> vertices;             ///< of the view, ascending
  std::vector<std::vector<Index>> groups;  ///< chosen holes that the field closes, those together that one sheet does
  std::vector<Index> caps;                 ///< chosen holes that patches close, ascending: the field ends at their rims
  std::vector<Index> seams;                ///< chosen rims at seams of views: what the field leaves open is patched
  std::vector<Index> triangles;            ///< of the view, ascending
  bool ends = false;                       ///< has rims that the field ends at
  std::size_t views = 0;                   ///< that it was joined of; 0: no seams
  std::size_t islands = 0;                 ///< of these, pieces in holes of others
};

/// What becomes of a rim, the stronger later: where several share a vertex the strongest holds there.
enum class RimFate {
  Field,  ///< the field closes it
  Seam,   ///< another view goes on there: the field ends only where all data are far
  Left,   ///< the field would lead away: it ends there, and a patch continues the surface
  Patch,  ///< the field ends there, and a patch closes it: a flat cap, or where no hole is but rim edges are
  Open    ///< a hole that wasn't chosen
};

/// A vertex on a rim.
struct RimPlace {
  Index vertex = 0;       ///< of the view
  Index hole = no_index;  ///< to be closed; no_index: stays open, or no hole is there
  RimFate fate = RimFate::Open;
  Vec3 outwards = Vec3::Zero();  ///< unit, the direction on from the surface; 0 where its edges give none
};

struct RemeshPieces {
  std::vector<RemeshPiece> pieces;  ///< by their lowest component
  std::vector<RimPlace> rims;       ///< by vertex, each once
  std::size_t left_out = 0;         ///< components below the least size
};

/// @param seams of views, which are joined; @param options whether everything is one piece (Preset::Paper), and the
/// least size of components
RemeshPieces make_pieces(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis,
                         const hole_filling::HoleChoice& choice, const ViewSeams& seams, const RemeshOptions& options);

/// Leaves those of a piece's groups of holes to patches for which that holds: where the field leads away.
void leave_to_patches(RemeshPieces& pieces, std::size_t piece,
                      const std::function<bool(const std::vector<Index>&)>& is_left);

}  // namespace croquis::remeshing
