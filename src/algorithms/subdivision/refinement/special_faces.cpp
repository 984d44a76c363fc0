// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/special_faces.h"

#include <algorithm>
#include <utility>

#include "algorithms/subdivision/levels/level_geometry.h"

namespace croquis::subdivision {
namespace {

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

}  // namespace

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

}  // namespace croquis::subdivision
