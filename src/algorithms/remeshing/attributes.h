// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/remeshing/backing.h"
#include "algorithms/remeshing/union.h"
#include "croquis/base/progress.h"

namespace croquis::remeshing {

/// Which new vertices lie in holes that were filled, and how much is known of them.
struct HoleMarks {
  std::vector<Index> hole;        ///< per new vertex; no_index on what was given
  std::vector<float> confidence;  ///< per new vertex: 1 on what was given, else its backing
};

/// The vertex channels of the mesh given but "confidence", with values 0 for so many vertices.
std::vector<AttributeChannel> channels_like(const PolyMesh& mesh, std::size_t vertex_count);

/// Leaves channels and marks of some vertices, and the labels of some faces. @param vertices,faces ascending
void keep_values(std::span<const Index> vertices, std::span<const Index> faces, std::vector<AttributeChannel>& channels,
                 HoleMarks& marks, std::vector<std::int32_t>& labels);

/// Sets the values of one piece's vertices of a part in the result's channels, interpolated in the nearest triangle
/// ("normal" is left 0: see compute_normals), and marks the vertices in holes.
/// @param made the result; its channels and the marks have values for all vertices @param cell of the cubes, model
/// units
/// @throws Cancelled
void transfer(PolyMesh& made, const RemeshPart& part, std::size_t piece, const NearestScan& given,
              const hole_filling::HoleAnalysis& analysis, const RemeshPieces& pieces, double cell, HoleMarks& marks,
              Progress& progress);

/// Sets the greatest fold across the rims and the least angle of every patch that has faces, on all its holes; NaN
/// where it has none.
/// @param patches per face, -1 for none; @param patch_of per hole
void measure_patches(const PolyMesh& mesh, const std::vector<std::int32_t>& patches, const std::vector<Index>& patch_of,
                     std::vector<hole_filling::HoleOutcome>& outcomes);

/// Fills a channel "normal" of three floating numbers per vertex, if there is one, from the faces around.
void compute_normals(PolyMesh& mesh, int threads, Progress& progress);

}  // namespace croquis::remeshing
