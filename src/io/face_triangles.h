// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Triangles for formats that hold nothing else.
struct FaceTriangles {
  std::vector<std::array<Index, 3>> triangles;  ///< #T by 3, vertices
  std::vector<Index> faces;                     ///< #T, the face each came from
  bool cut_polygons = false;                    ///< some face had more than 3 corners
};

/// Convex faces by the fan from their first corner; others by the constrained Delaunay triangulation in their best
/// plane, or by the fan where they overlap themselves there. k - 2 triangles for k corners, oriented like the face.
FaceTriangles face_triangles(const PolyMesh& mesh);

}  // namespace croquis
