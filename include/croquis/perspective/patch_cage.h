// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis {

struct PatchCageOptions {
  std::size_t segments = 4;  ///< along a curve: even, 2..64
};

struct PatchCage {
  PolyMesh mesh;
  Findings warnings;  ///< PATCH_FOLDED: plane faces whose outlines cross at so few segments
};

/// A control mesh for subdivision with the topology of a solid: as closed as its shells, with their Euler number.
///
/// A face of four sides becomes a grid of quads, one of n sides n grids around its middle, split at the middles of its
/// sides as its patches are. Plane faces become convex polygons; those with holes or reflex corners are divided by as
/// few diagonals as a Delaunay triangulation has left after every one was taken away that needn't be there (Hertel and
/// Mehlhorn 1983), so that they stay plane under every scheme. A straight edge is divided only where a patch needs it.
/// Vertices on edges lie on the exact curves.
///
/// Edges along which the solid isn't smooth are infinitely sharp, and so are cuts of plane faces between two corners of
/// the solid, which would move beyond reflex corners else; vertices where two of these meet at a corner of their
/// curves are pinned.
/// @pre 2 <= segments, even
/// @throws Cancelled
PatchCage make_patch_cage(const Brep& brep, const PatchCageOptions& options, Progress& progress);

}  // namespace croquis
