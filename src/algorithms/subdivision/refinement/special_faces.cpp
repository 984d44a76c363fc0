// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/special_faces.h"

#include <numeric>

#include "algorithms/subdivision/levels/level_geometry.h"

namespace croquis::subdivision {
namespace {

/// Corners of unbanded sectors at which their faces take a point of the chain.
std::vector<Index> replaced_corners(const Sectors& sectors) {
  std::vector<Index> replaced;
  for (const Sector& sector : sectors.list) {
    if (sector.banded) continue;
    replaced.push_back(sectors.corners[sector.begin]);
    replaced.push_back(sectors.corners[sector.end - 1]);
  }
  return replaced;
}

class Lister {
 public:
  Lister(const Neighbourhood& near, const PlainParts& plain) : near_(near), plain_(plain) {}

  FaceList run() {
    for (const Index edge : plain_.edges.left_out()) {
      if (!near_.classes.sharp(edge)) list_edge_face(edge);
    }
    for (const Index vertex : plain_.bordering) list_vertex_face(vertex);
    for (const Sector& sector : near_.sectors.list) list_sector_faces(sector);
    for (Index line = 0; line < near_.classes.lines.size(); ++line) list_bands(line);
    return std::move(list_);
  }

 private:
  Index at(Index corner) const { return near_.points.at(corner); }

  Index chain(Index line, Index vertex) const { return near_.points.chain_at(near_.classes, line, vertex); }

  void append(Index point) {
    if (point != no_index && (face_.empty() || face_.back() != point)) face_.push_back(point);
  }

  void finish(const FaceOrigin& origin) {
    while (face_.size() > 1 && face_.front() == face_.back()) face_.pop_back();
    if (face_.size() >= 3) {
      list_.vertices.insert(list_.vertices.end(), face_.begin(), face_.end());
      list_.offsets.push_back(static_cast<Index>(list_.vertices.size()));
      list_.origins.push_back(origin);
    }
    face_.clear();
  }

  void list_edge_face(Index edge) {
    const Index half_edge = near_.level.topology.edge_corner[edge];
    for (const Index h : {half_edge, near_.level.topology.twin[half_edge]}) {
      append(at(near_.around.next(h)));
      append(at(h));
      append(near_.points.spoke(h));
    }
    finish({FaceKind::Edge, edge});
  }

  void list_vertex_face(Index vertex) {
    for_each_corner(near_.level.topology, near_.around, vertex, [&](Index corner) { append(at(corner)); });
    finish({FaceKind::Vertex, vertex});
  }

  void list_sector_faces(const Sector& sector) {
    const VertexClass vertex_class = near_.classes.class_of[sector.vertex];
    if (sector.banded && vertex_class == VertexClass::Corner) return list_corner_quads(sector);
    const bool between_chain_points = sector.banded || vertex_class == VertexClass::Dart;
    if (between_chain_points) append(chain(sector.first_line, sector.vertex));
    for (const Index corner : near_.sectors.corners_of(sector)) append(at(corner));
    if (between_chain_points) append(chain(sector.last_line, sector.vertex));
    finish({FaceKind::Vertex, sector.vertex});
  }

  /// A fan of quads around a kept vertex, between the chain points and the spokes.
  void list_corner_quads(const Sector& sector) {
    Index before = chain(sector.first_line, sector.vertex);
    for (Index i = sector.begin; i < sector.end; ++i) {
      const bool last = i + 1 == sector.end;
      const Index after =
          last ? chain(sector.last_line, sector.vertex) : near_.points.spoke(near_.sectors.corners[i + std::size_t{1}]);
      append(near_.points.kept(sector.vertex));
      append(before);
      append(at(near_.sectors.corners[i]));
      append(after);
      finish({FaceKind::Vertex, sector.vertex});
      before = after;
    }
  }

  void list_bands(Index line) {
    const SharpLine& sharp = near_.classes.lines[line];
    for (std::size_t side = 0; side < 2; ++side) {
      const Index half_edge = sharp.half_edges[side];
      if (half_edge == no_index || !near_.sectors.side_banded[2 * line + side]) continue;
      append(near_.points.chain(line, side));
      append(near_.points.chain(line, 1 - side));
      append(at(near_.around.next(half_edge)));
      append(at(half_edge));
      finish({FaceKind::Band, sharp.edge});
    }
  }

  const Neighbourhood& near_;
  const PlainParts& plain_;
  std::vector<Index> face_;
  FaceList list_;
};

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

NewPoints::NewPoints(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors)
    : own_(replaced_corners(sectors), mesh.corner_count()) {
  list_kept(classes);
  list_chain_ends(classes, sectors);
  list_spokes(mesh, classes, sectors);
  list_corner_points(mesh, classes, sectors);
}

Index NewPoints::find(const Table& table, Index element) {
  const auto found = std::lower_bound(table.begin(), table.end(), std::pair(element, Index{0}));
  return found != table.end() && found->first == element ? found->second : no_index;
}

Index NewPoints::list_point(const VertexOrigin& origin) {
  listed_.push_back(origin);
  return static_cast<Index>(count() - 1);
}

void NewPoints::list_kept(const TagClasses& classes) {
  for (const Index vertex : classes.special) {
    if (classes.class_of[vertex] != VertexClass::Corner) continue;
    kept_.emplace_back(vertex, list_point({PointKind::Kept, vertex, vertex}));
  }
}

void NewPoints::list_chain_ends(const TagClasses& classes, const Sectors& sectors) {
  chain_.resize(classes.lines.size());
  for (Index line = 0; line < classes.lines.size(); ++line) {
    const bool banded = sectors.side_banded[2 * line] || sectors.side_banded[2 * line + 1];
    for (std::size_t end = 0; end < 2; ++end) {
      const Index vertex = classes.lines[line].vertices[end];
      chain_[line][end] = !banded && classes.class_of[vertex] == VertexClass::Corner
                              ? kept(vertex)
                              : list_point({PointKind::Chain, vertex, classes.lines[line].edge});
    }
  }
}

void NewPoints::list_spokes(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors) {
  for (const Sector& sector : sectors.list) {
    if (!sector.banded || classes.class_of[sector.vertex] != VertexClass::Corner) continue;
    for (Index i = sector.begin + 1; i < sector.end; ++i) {
      const Index half_edge = sectors.corners[i];
      spokes_.emplace_back(half_edge, list_point({PointKind::Spoke, sector.vertex, mesh.corner_edge[half_edge]}));
    }
  }
  std::sort(spokes_.begin(), spokes_.end());
}

void NewPoints::list_corner_points(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors) {
  if (own_.left_out().empty()) return;
  points_.resize(mesh.corner_count());
  own_.for_each_run([&](Index begin, Index end, Index first_point) {
    std::iota(points_.begin() + begin, points_.begin() + end, first_point);
  });
  for (const Sector& sector : sectors.list) {
    if (sector.banded) continue;
    // With a single face both are the same corner, of a surface's corner, and both points the kept one.
    points_[sectors.corners[sector.begin]] = chain_at(classes, sector.first_line, sector.vertex);
    points_[sectors.corners[sector.end - 1]] = chain_at(classes, sector.last_line, sector.vertex);
  }
}

PlainParts find_plain_parts(const HalfEdges& mesh, const CornerFaces& around, const TagClasses& classes) {
  PlainParts plain;
  std::vector<Index> edges, faces, vertices = classes.special;
  const auto visit_edge = [&](Index half_edge, Index other_end) {
    edges.push_back(mesh.corner_edge[half_edge]);
    if (classes.class_of[other_end] == VertexClass::Plain) plain.bordering.push_back(other_end);
  };
  for (const Index vertex : classes.special) {
    for_each_corner(mesh, around, vertex, [&](Index corner) {
      const Index arriving = around.previous(corner);
      faces.push_back(around.face(corner));
      visit_edge(corner, mesh.corner_vertex[around.next(corner)]);
      visit_edge(arriving, mesh.corner_vertex[arriving]);
    });
  }
  std::sort(plain.bordering.begin(), plain.bordering.end());
  plain.bordering.erase(std::unique(plain.bordering.begin(), plain.bordering.end()), plain.bordering.end());
  vertices.insert(vertices.end(), plain.bordering.begin(), plain.bordering.end());
  plain.edges = Compaction(std::move(edges), mesh.edge_count());
  plain.vertices = Compaction(std::move(vertices), mesh.vertex_count());
  plain.faces = Compaction(std::move(faces), mesh.face_count());
  return plain;
}

FaceList list_special_faces(const Neighbourhood& near, const PlainParts& plain) { return Lister(near, plain).run(); }

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
