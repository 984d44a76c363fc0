// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "algorithms/subdivision/refinement/new_points.h"
#include "algorithms/subdivision/refinement/special_faces.h"
#include "croquis/base/progress.h"
#include "croquis/subdivision/half_edges.h"

namespace croquis::subdivision {

/// Where the parts of the next level lie. Its faces and their corners in this order: the old faces' (with the corners'
/// old numbers), the quads of plain edges, the faces of plain vertices, the listed ones.
struct Layout {
  Index quads_begin = 0;  ///< first corner of each part
  Index vertex_faces_begin = 0;
  Index listed_begin = 0;
  std::size_t vertices = 0, edges = 0, faces = 0, corners = 0;
};

/// Memory of a refinement, kept for the next.
struct FlatScratch {
  IndexArray quad_of_edge;  ///< #E old: the first corner of its quad, no_index without
  IndexArray turned;        ///< #C old: the next corner counter-clockwise around the vertex
};

void number_quads(const HalfEdges& old, const PlainParts& plain, const Layout& layout, FlatScratch& scratch);

/// Which corner of its edge's quad takes a half-edge's place: each half-edge of an edge fills two corners.
inline Index quad_corner(const HalfEdges& old, const FlatScratch& scratch, Index half_edge) {
  return scratch.quad_of_edge[old.corner_edge[half_edge]] + (half_edge < old.twin[half_edge] ? 0 : 2);
}

/// Doo, Sabin 1978: all that follows from the old numbers alone, without a search. Fills everything of `next`, whose
/// arrays have their sizes, but what belongs to listed faces or to edges that aren't plain.
void connect_plain_parts(const HalfEdges& old, const NewPoints& points, const PlainParts& plain, const Layout& layout,
                         FlatScratch& scratch, HalfEdges& next, const Progress& progress);

}  // namespace croquis::subdivision
