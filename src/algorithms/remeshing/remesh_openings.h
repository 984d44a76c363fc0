// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "algorithms/remeshing/remesh_pieces.h"
#include "croquis/base/progress.h"

namespace croquis::remeshing {

/// Rims of a new surface that shouldn't be there.
struct Openings {
  std::vector<Index> loops;    ///< ids in an analysis of the surface
  std::vector<Index> holes;    ///< per loop, the hole of the mesh given that is open there; no_index: none
  std::vector<RimFate> fates;  ///< per loop: what its rim was left to; a patch is flat
  std::size_t meant = 0;       ///< other loops: they lie along rims that stay open
  std::vector<Index> left;     ///< chosen rims of views along these: no hole of the joined views after all

  bool none() const { return loops.empty(); }

  /// Some that the field should have closed.
  bool any_of_field() const { return std::find(fates.begin(), fates.end(), RimFate::Field) != fates.end(); }
};

/// Every loop belongs to the rim that most of its vertices are nearest to. What views leave open between them is a hole
/// of its own, which the selection names or not.
/// @param surface what came out for the piece; @param rims of the whole mesh given
/// @throws Cancelled
Openings find_openings(const PolyMesh& surface, const PolyMesh& mesh, const RemeshPiece& piece,
                       const std::vector<RimPlace>& rims, const hole_filling::FillOptions& options, Progress& progress);

/// A hole that a patch closed.
struct PatchedHole {
  Index hole = no_index;              ///< of the mesh given; no_index: none
  RimFate fate = RimFate::Field;      ///< as in Openings
  hole_filling::HoleOutcome outcome;  ///< of the patch
};

/// What close_by_patches did.
struct PatchedHoles {
  std::vector<PatchedHole> loops;                    ///< those that were closed
  std::vector<std::pair<std::size_t, Index>> faces;  ///< of patches, with the hole of the mesh given, ascending
};

/// Closes the loops by patches, the best that is sound for each, flat where so marked, or where views leave open what
/// nothing near shows, and takes those that were closed
/// out of the openings.
/// @throws Cancelled
PatchedHoles close_by_patches(PolyMesh& surface, Openings& openings, const hole_filling::FillOptions& options,
                              Progress& progress);

}  // namespace croquis::remeshing
