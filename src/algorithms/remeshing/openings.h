// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "algorithms/remeshing/pieces.h"
#include "croquis/base/progress.h"

namespace croquis::remeshing {

/// A rim of a new surface that shouldn't be there.
struct Opening {
  Index loop = no_index;          ///< id in an analysis of the surface
  Index hole = no_index;          ///< of the mesh given, that is open there; no_index: none
  RimRule rule = RimRule::Field;  ///< of the rim there: a patch is flat
};

struct Openings {
  std::vector<Opening> loops;
  std::size_t meant = 0;    ///< other loops: they lie along rims that stay open
  std::vector<Index> left;  ///< chosen rims of views along these: no hole of the joined views after all

  /// Some that the field should have closed.
  bool any_of_field() const { return std::ranges::find(loops, RimRule::Field, &Opening::rule) != loops.end(); }
  std::vector<Index> holes() const;
};

/// Every loop belongs to the rim that most of its vertices are nearest to. What views leave open between them is a hole
/// of its own, which the selection names or not.
/// @param surface what came out for the piece; @param pieces for the rims of the whole mesh given
/// @throws Cancelled
Openings find_openings(const PolyMesh& surface, const PolyMesh& mesh, const RemeshPiece& piece,
                       const RemeshPieces& pieces, const hole_filling::FillOptions& options, Progress progress);

/// What close_by_patches did.
struct PatchedOpenings {
  std::vector<std::pair<Opening, hole_filling::HoleOutcome>> closed;  ///< with the outcome of the patch
  std::vector<std::pair<std::size_t, Index>> faces;  ///< of patches, with the hole of the mesh given, ascending
};

/// Closes the loops by patches, the best that is sound for each, flat where so marked, or where views leave open what
/// nothing near shows, and takes those that were closed out of the openings.
/// @throws Cancelled
PatchedOpenings close_by_patches(PolyMesh& surface, Openings& openings, const hole_filling::FillOptions& options,
                                 Progress progress);

}  // namespace croquis::remeshing
