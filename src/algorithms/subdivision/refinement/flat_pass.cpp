// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/flat_pass.h"

#include <algorithm>
#include <numeric>

namespace croquis::subdivision {
namespace {

/// The corners of old faces: their points by runs of own points, else by the list.
void place_face_points(const NewPoints& points, HalfEdges& next, const Progress& progress) {
  points.own().for_each_run([&](Index begin, Index end, Index first_point) {
    progress.check();
    std::iota(next.corner_vertex.begin() + begin, next.corner_vertex.begin() + end, first_point);
    std::iota(next.vertex_corner.begin() + first_point, next.vertex_corner.begin() + first_point + (end - begin),
              begin);
  });
  for (const Index corner : points.own().left_out()) next.corner_vertex[corner] = points.at(corner);
}

/// One half-edge of an old face: its new corner, and its half of the edge's quad. Quads run (end of h, start of h, end
/// of twin, start of twin); the first and third half-edge meet the old faces, the others the faces of vertices.
inline void connect_half_edge(const HalfEdges& old, const FlatScratch& scratch, Index quads_begin, Index corner,
                              Index after, HalfEdges& next) {
  const Index quad = quad_corner(old, scratch, corner);
  next.twin[corner] = quad;
  next.corner_edge[corner] = quad - quads_begin;
  next.corner_vertex[quad] = next.corner_vertex[after];
  next.corner_vertex[quad + 1] = next.corner_vertex[corner];
  next.twin[quad] = corner;
}

/// @tparam AllPlain whether all edges of the faces are
template <bool AllPlain>
void connect_face(const HalfEdges& old, Index face, Index quads_begin, FlatScratch& scratch, HalfEdges& next) {
  const Index begin = old.face_offsets[face], end = old.face_offsets[face + std::size_t{1}];
  Index previous = end - 1;
  for (Index corner = begin; corner < end; previous = corner++) {
    scratch.turned[corner] = old.twin[previous];
    if (!AllPlain && scratch.quad_of_edge[old.corner_edge[previous]] == no_index) continue;
    connect_half_edge(old, scratch, quads_begin, previous, corner, next);
  }
}

void connect_faces(const HalfEdges& old, const PlainParts& plain, Index quads_begin, FlatScratch& scratch,
                   HalfEdges& next, const Progress& progress) {
  scratch.turned.resize(old.corner_count());
  plain.faces.for_each_run([&](Index begin, Index end, Index) {
    progress.check();
    for (Index face = begin; face < end; ++face) connect_face<true>(old, face, quads_begin, scratch, next);
  });
  for (const Index face : plain.faces.left_out()) connect_face<false>(old, face, quads_begin, scratch, next);
}

/// Quads number their edges by their own corners.
void number_quad_edges(const Layout& layout, HalfEdges& next) {
  const auto count = static_cast<std::ptrdiff_t>(layout.vertex_faces_begin - layout.quads_begin);
  std::iota(next.edge_corner.begin(), next.edge_corner.begin() + count, layout.quads_begin);
  const auto begin = next.corner_edge.begin() + layout.quads_begin;
  std::iota(begin, begin + count, Index{0});
}

/// The face of a vertex meets, from the point of one corner to that of the next, the quad of the edge between both:
/// there the half-edge after the one that meets the next corner's face.
inline Index connect_vertex_face(const HalfEdges& old, const FlatScratch& scratch, Index quads_begin, Index vertex,
                                 Index place, HalfEdges& next) {
  const Index start = old.vertex_corner[vertex];
  Index corner = start;
  do {
    const Index after = scratch.turned[corner];
    const Index twin = next.twin[after] + 1;
    next.corner_vertex[place] = next.corner_vertex[corner];
    next.twin[place] = twin;
    next.corner_edge[place] = twin - quads_begin;
    next.twin[twin] = place++;
    corner = after;
  } while (corner != start);
  return place;
}

void connect_vertices(const HalfEdges& old, const PlainParts& plain, const Layout& layout, const FlatScratch& scratch,
                      HalfEdges& next, const Progress& progress) {
  Index place = layout.vertex_faces_begin;
  std::size_t face = old.face_count() + plain.edges.kept_count();
  plain.vertices.for_each_run([&](Index begin, Index end, Index) {
    progress.check();
    for (Index vertex = begin; vertex < end; ++vertex) {
      next.face_offsets[face++] = place;
      place = connect_vertex_face(old, scratch, layout.quads_begin, vertex, place, next);
    }
  });
}

void place_faces(const HalfEdges& old, const PlainParts& plain, const Layout& layout, HalfEdges& next) {
  std::copy(old.face_offsets.begin(), old.face_offsets.end() - 1, next.face_offsets.begin());
  Index place = layout.quads_begin;
  for (std::size_t i = 0; i < plain.edges.kept_count(); ++i, place += 4) {
    next.face_offsets[old.face_count() + i] = place;
  }
}

}  // namespace

void number_quads(const HalfEdges& old, const PlainParts& plain, const Layout& layout, FlatScratch& scratch) {
  scratch.quad_of_edge.resize(old.edge_count());
  plain.edges.for_each_run([&](Index begin, Index end, Index rank) {
    Index quad = layout.quads_begin + 4 * rank;
    for (Index edge = begin; edge < end; ++edge, quad += 4) scratch.quad_of_edge[edge] = quad;
  });
  for (const Index edge : plain.edges.left_out()) scratch.quad_of_edge[edge] = no_index;
}

void connect_plain_parts(const HalfEdges& old, const NewPoints& points, const PlainParts& plain, const Layout& layout,
                         FlatScratch& scratch, HalfEdges& next, const Progress& progress) {
  place_faces(old, plain, layout, next);
  place_face_points(points, next, progress);
  number_quad_edges(layout, next);
  connect_faces(old, plain, layout.quads_begin, scratch, next, progress);
  connect_vertices(old, plain, layout, scratch, next, progress);
}

}  // namespace croquis::subdivision
