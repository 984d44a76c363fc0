// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/remeshing/solids/remesh_union.h"

namespace croquis::remeshing {

/// What is left of a mesh where faces were merged.
struct MergedFaces {
  std::vector<Index> vertex_of;  ///< per vertex that is left, ascending: its number before
  std::vector<Index> face_of;    ///< per face that is left, ascending: whose place it has
  PolyMesh mesh;                 ///< positions and triangles
};

/// Merges faces where the surface is flat (see collapse_edges), by options.adaptive cells at most: proven in both
/// directions for all points of both surfaces. Borders, where labels of faces change, and vertices that are off the
/// scan anyhow stay. What would cut through something that it didn't cut before, lie off the scan between vertices, or
/// change the room that a piece takes, is left as it was, as is what no proof is found for.
/// @param made all surfaces, of `parts` @param labels per face @throws Cancelled
MergedFaces merge_flat_faces(const RemeshModel& model, const PolyMesh& made, const std::vector<RemeshPart>& parts,
                             const std::vector<PieceShape>& shapes, std::span<const std::int32_t> labels,
                             Progress& progress);

}  // namespace croquis::remeshing
