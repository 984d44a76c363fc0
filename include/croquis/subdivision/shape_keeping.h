// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/poly_mesh.h"

/// Tags that keep parts of a cage as they are under subdivision, whatever the scheme.
///
/// All functions return the mesh with more tags; tags that are there stay, and a crease that is asked for again becomes
/// infinite. Boundary edges get no tag, since every scheme keeps boundaries sharp by itself.
namespace croquis::subdivision {

struct KeptRegion {
  PolyMesh mesh;
  std::vector<Index> source_face;  ///< #F of `mesh`, the face of the given mesh that each came from
  std::vector<Index> region;       ///< the region's faces in `mesh`, ascending
  Findings notices;                ///< W_TRIANGULATED with the number of faces that were cut
};

/// Whether no corner lies farther than 1e-6 of the face's diameter off the plane through its centre.
bool is_planar(const PolyMesh& mesh, Index face);

/// Tags all edges of the faces as sharp for ever and pins their vertices: every level then holds these faces with
/// distance 0. Faces that aren't planar are cut into triangles first, since only a triangle has one surface to keep;
/// attributes of faces and corners go along.
/// @param faces indices of faces, in any order; may be empty
/// @throws Error (E_INDEX) for a face that isn't there or a mesh with indices out of range
KeptRegion keep_region(const PolyMesh& mesh, std::span<const Index> faces);

/// Tags and pins the border of the region alone: the edges with the region on one side and something else on the
/// other. The inside stays smooth.
/// @throws Error (E_INDEX) as keep_region
PolyMesh keep_outline(const PolyMesh& mesh, std::span<const Index> faces);

/// Pins the vertices at which exactly two tagged edges meet and turn by more than the angle: the chain keeps its kink
/// there. Chains turn back and forth in any plane; vertices on the boundary are left out.
/// @param least_turn radians, 0 for a straight chain; a customary choice is 45 degrees
/// @throws Error (E_INDEX) for a mesh with indices out of range
PolyMesh pin_kinks(const PolyMesh& mesh, double least_turn);

}  // namespace croquis::subdivision
