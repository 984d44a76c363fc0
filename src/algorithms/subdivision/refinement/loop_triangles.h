// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/subdivision/half_edges.h"

namespace croquis::subdivision {

/// The triangles that Loop's scheme refines.
struct LoopTriangles {
  std::vector<Index> corners;        ///< 3 per triangle
  std::vector<Index> source_face;    ///< #T, the face each came from
  std::vector<Index> centred_faces;  ///< faces with a new vertex in the middle, which is #V, #V+1, … in this order
  std::size_t cut_faces = 0;         ///< faces that weren't triangles
};

/// Cuts faces by connectivity alone: fans from the corner that keeps valences lowest, so that the same cage is cut the
/// same way wherever its points are. No diagonal joins vertices that are joined already. O(n^2) for a face of n
/// corners up to 64; larger ones get a centre at once.
LoopTriangles loop_triangles(const HalfEdges& mesh);

}  // namespace croquis::subdivision
