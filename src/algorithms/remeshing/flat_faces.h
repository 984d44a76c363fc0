// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/remeshing/union.h"
#include "croquis/geometry/triangle_tree.h"

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
/// change the extent of a piece, is left as it was, as is what no proof is found for.
/// @param made all surfaces, of `parts` @param labels per face @throws Cancelled
MergedFaces merge_flat_faces(const RemeshModel& model, const PolyMesh& made, const std::vector<RemeshPart>& parts,
                             const std::vector<PieceShape>& shapes, std::span<const std::int32_t> labels,
                             Progress progress);

/// Triangles that aren't proven to lie within a distance of a surface with all their points, ascending. A proof is one
/// triangle of the surface that all corners are near to, since that holds for everything between them then; else
/// triangles are cut along the edges of what is nearest to their middle, or in halves, down to 2 % of the distance.
/// None is proven that has a point farther away; one that has a point almost so far may be missed.
/// @param guesses a triangle of the surface for each that may be near to all of it, or no_index; none: of no triangle
/// @throws Cancelled
std::vector<Index> faces_beyond(std::span<const std::array<Vec3, 3>> triangles, std::span<const Index> guesses,
                                const TriangleTree& surface, double distance, int threads, Progress& progress);

}  // namespace croquis::remeshing
