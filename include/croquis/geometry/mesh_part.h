// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// What remains of a mesh, and where it was.
struct MeshPart {
  PolyMesh mesh;
  std::vector<Index> vertices;  ///< #V of the part: their numbers in the whole, ascending
  std::vector<Index> faces;     ///< #F of the part, likewise
};

/// A mesh without some of its vertices and faces, and without the faces, polylines and tags that use vertices that go.
/// What remains keeps its order and its attributes. Linear.
/// @param keep_vertex #V
/// @param keep_face   #F
MeshPart part_of(const PolyMesh& mesh, const std::vector<bool>& keep_vertex, const std::vector<bool>& keep_face);

}  // namespace croquis
