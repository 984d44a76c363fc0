// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/hole_filling/remesh_pieces.h"
#include "croquis/base/progress.h"

namespace croquis::hole_filling {

/// Rims of a new surface that shouldn't be there.
struct Openings {
  std::vector<Index> loops;  ///< ids in an analysis of the surface
  std::vector<Index> holes;  ///< per loop, the hole of the mesh given that is open there; no_index: none
  std::size_t meant = 0;     ///< other loops: they lie along rims that stay open

  bool none() const { return loops.empty(); }
};

/// Every loop belongs to the rim that most of its vertices are nearest to.
/// @param surface what came out for the piece; @param rims of the whole mesh given
/// @throws Cancelled
Openings find_openings(const PolyMesh& surface, const PolyMesh& mesh, const RemeshPiece& piece,
                       const std::vector<RimPlace>& rims, int threads, Progress& progress);

/// Closes the loops by patches, the best that is sound for each, and takes those that were closed out of the openings.
/// @return how many were closed
/// @throws Cancelled
std::size_t close_by_patches(PolyMesh& surface, Openings& openings, const FillOptions& options, Progress& progress);

}  // namespace croquis::hole_filling
