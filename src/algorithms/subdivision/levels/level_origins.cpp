// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/refine.h"

namespace croquis::subdivision {

FaceOrigin LevelOrigins::face(Index face, const HalfEdges& old, const HalfEdges& made) const {
  if (face < old_faces) return {FaceKind::Face, face};
  Index rank = face - old_faces;
  if (rank < quads) {
    const Index old_half_edge = made.twin[quads_begin + 4 * rank];  // corners of old faces keep their numbers
    return {FaceKind::Edge, old.corner_edge[old_half_edge]};
  }
  rank -= quads;
  if (rank < plain_vertices.kept_count()) return {FaceKind::Vertex, plain_vertices.element(rank)};
  return listed_faces[rank - plain_vertices.kept_count()];
}

VertexOrigin LevelOrigins::vertex(Index vertex, const HalfEdges& old) const {
  if (vertex >= own_corners.kept_count()) return listed[vertex - own_corners.kept_count()];
  const Index corner = own_corners.element(vertex);
  return {PointKind::Corner, old.corner_vertex[corner], corner};
}

}  // namespace croquis::subdivision
