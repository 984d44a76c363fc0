// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/hole_filling/remesh.h"

namespace croquis::hole_filling {

/// A part of the mesh that gets a function of its own: a component, or several that share vertices or a hole to fill.
struct RemeshPiece {
  std::vector<Index> vertices;             ///< of the view, ascending
  std::vector<std::vector<Index>> groups;  ///< chosen holes, those together that one surface closes
  std::vector<Index> triangles;            ///< of the view, ascending
  bool stays_open = false;                 ///< has rims that aren't to be closed
};

/// A vertex on a rim.
struct RimPlace {
  Index vertex = 0;              ///< of the view
  Index hole = no_index;         ///< to be closed; no_index: stays open
  Vec3 outwards = Vec3::Zero();  ///< unit, the way on from the surface; 0 where its edges tell nothing
};

struct RemeshPieces {
  std::vector<RemeshPiece> pieces;  ///< by their lowest component
  std::vector<RimPlace> rims;       ///< by vertex, each once; a vertex of several rims counts as open if one is
  std::size_t left_out = 0;         ///< components below the least size
};

/// @param options whether everything is one piece (Preset::Paper), and the least size of components
RemeshPieces make_pieces(const PolyMesh& mesh, const HoleAnalysis& analysis, const HoleChoice& choice,
                         const RemeshOptions& options);

}  // namespace croquis::hole_filling
