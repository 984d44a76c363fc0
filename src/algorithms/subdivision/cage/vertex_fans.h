// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/vector.h"
#include "croquis/subdivision/half_edges.h"

namespace croquis::subdivision {

/// What became of the vertices of a mesh whose vertices may have any number of fans.
struct VertexFans {
  std::vector<Index> source_vertex;  ///< #V of the fans -> vertex before
  std::vector<Index> split;          ///< vertices that had several fans, ascending
  std::vector<Index> loose;          ///< vertices that had none, ascending
};

/// Makes each fan a vertex of its own: by old vertex, then by lowest corner. Rewrites corner_vertex and fills
/// vertex_corner. Linear time.
/// @param mesh all but vertex_corner filled
VertexFans split_vertices_into_fans(HalfEdges& mesh, std::size_t vertex_count);

}  // namespace croquis::subdivision
