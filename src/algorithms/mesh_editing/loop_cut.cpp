// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "algorithms/mesh_editing/edge_walk.h"
#include "algorithms/mesh_editing/mesh_rebuild.h"
#include "croquis/base/error.h"
#include "croquis/mesh_editing/mesh_edit.h"

namespace croquis {
namespace {

/// Nearer to an end, the pieces would count as having no length in most programs.
constexpr double least_part = 0.001;

double usable_part(double at) { return std::clamp(at, least_part, 1 - least_part); }

/// Which edges get a new vertex, and which faces are cut.
struct Cut {
  EdgeRing ring;
  double at = 0.5;
  Index first_vertex = 0;       ///< of the new ones: ring edge i gets first_vertex + i
  std::vector<Index> place;     ///< #E: place in the ring, or no_index
  std::vector<char> cuts_face;  ///< #F

  Cut(const MeshTopology& topology, EdgeRing walked, double part)
      : ring(std::move(walked)),
        at(part),
        first_vertex(static_cast<Index>(topology.vertex_count())),
        place(topology.edge_count(), no_index),
        cuts_face(topology.face_count(), 0) {
    for (Index i = 0; i < ring.edges.size(); ++i) place[ring.edges[i].edge] = i;
    for (const Index face : ring.faces) cuts_face[face] = 1;
  }

  /// The new vertex of an edge, or no_index.
  Index vertex_of(Index edge) const {
    return edge == no_index || place[edge] == no_index ? no_index : first_vertex + place[edge];
  }

  /// 0..1 from a corner of the edge on.
  double part_from(const MeshTopology& topology, Index corner) const {
    return topology.vertex(corner) == ring.edges[place[topology.edge(corner)]].from ? at : 1 - at;
  }

  /// Whether a face is cut from this edge to that one, which follow each other in the ring.
  bool joins(Index edge, Index other) const {
    const Index low = std::min(place[edge], place[other]);
    const Index high = std::max(place[edge], place[other]);
    return high == low + 1 || (ring.closed && low == 0 && high + std::size_t{1} == ring.edges.size());
  }
};

/// A face's outline with the new vertices in it.
struct Outline {
  std::vector<Index> vertices;
  std::vector<Blend> sources;
  std::vector<Index> edges;  ///< per vertex: of new ones the edge they cut, else no_index
};

Outline outline_of(const PolyMesh& mesh, const MeshTopology& topology, const Cut& cut, Index face) {
  Outline outline;
  const auto add = [&](Index vertex, const Blend& source, Index edge) {
    outline.vertices.push_back(vertex);
    outline.sources.push_back(source);
    outline.edges.push_back(edge);
  };
  for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + 1]; ++corner) {
    add(mesh.corners[corner], {corner, no_index, 0}, no_index);
    const Index edge = topology.edge(corner);
    const Index vertex = cut.vertex_of(edge);
    if (vertex != no_index) add(vertex, {corner, topology.next(corner), cut.part_from(topology, corner)}, edge);
  }
  return outline;
}

/// Adds the part of an outline from one place to another, both included.
void add_piece(MeshPlan& plan, const Outline& outline, std::size_t from, std::size_t to, Index face) {
  for (std::size_t i = from;; i = (i + 1) % outline.vertices.size()) {
    plan.add_corner(outline.vertices[i], outline.sources[i]);
    if (i == to) break;
  }
  plan.end_face(face);
}

/// The two places between which a quad is cut: on opposite sides, and neighbours in the ring.
std::pair<std::size_t, std::size_t> cut_places(const MeshTopology& topology, const Cut& cut, const Outline& outline) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < outline.edges.size(); ++i) {
    if (outline.edges[i] != no_index) places.push_back(i);
  }
  const auto meet = [&](Index a, Index b) {
    const auto [p, q] = topology.edge_vertices(a);
    const auto [r, s] = topology.edge_vertices(b);
    return p == r || p == s || q == r || q == s;
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = i + 1; k < places.size(); ++k) {
      const Index a = outline.edges[places[i]];
      const Index b = outline.edges[places[k]];
      if (!meet(a, b) && cut.joins(a, b)) return {places[i], places[k]};
    }
  }
  throw Error(make_error(Category::Internal, "E_INTERNAL", "A ring of edges doesn't run across its faces."));
}

void add_face(MeshPlan& plan, const PolyMesh& mesh, const MeshTopology& topology, const Cut& cut, Index face,
              std::vector<VertexPair>& new_edges) {
  const Outline outline = outline_of(mesh, topology, cut, face);
  if (cut.cuts_face[face] == 0) return add_piece(plan, outline, 0, outline.vertices.size() - 1, face);
  const auto [a, b] = cut_places(topology, cut, outline);
  add_piece(plan, outline, a, b, face);
  add_piece(plan, outline, b, a, face);
  new_edges.push_back(ordered_pair(outline.vertices[a], outline.vertices[b]));
}

void require_edge(const MeshTopology& topology, Index edge) {
  if (edge < topology.edge_count()) return;
  throw Error(
      make_error(Category::Usage, "E_INPUT",
                 "The mesh has no edge " + std::to_string(edge) + ": it has " + std::to_string(topology.edge_count())));
}

bool touches_cut(const PolyMesh& mesh, const MeshTopology& topology, const Cut& cut, Index face) {
  for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + 1]; ++corner) {
    if (cut.vertex_of(topology.edge(corner)) != no_index) return true;
  }
  return false;
}

}  // namespace

MeshEdit loop_cut(const PolyMesh& mesh, const MeshTopology& topology, Index edge, double at) {
  require_edge(topology, edge);
  const Cut cut(topology, walk_ring(topology, edge), usable_part(at));
  if (cut.ring.faces.empty()) {
    throw Error(make_error(Category::Usage, "E_INPUT",
                           "Edge " + std::to_string(edge) + " has no quad face: a loop cut needs one"));
  }
  MeshPlan plan = plan_with_vertices_of(mesh);
  for (const DirectedEdge& ring_edge : cut.ring.edges)
    plan.vertices.push_back({ring_edge.from, other_end(topology, ring_edge.edge, ring_edge.from), cut.at});
  std::vector<VertexPair> new_edges;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (touches_cut(mesh, topology, cut, face)) {
      add_face(plan, mesh, topology, cut, face, new_edges);
    } else {
      keep_face(plan, mesh, face);
    }
  }
  MeshEdit edit = rebuilt(mesh, plan, all_elements(mesh.vertex_count()));
  edit.new_edges = std::move(new_edges);
  TagMap map;
  map.edge = [&](const VertexPair& pair) -> std::vector<VertexPair> {
    const Index tagged = find_edge(topology, pair[0], pair[1]);
    const Index vertex = tagged == no_index ? no_index : cut.vertex_of(tagged);
    if (vertex == no_index) return {pair};
    return {{pair[0], vertex}, {vertex, pair[1]}};
  };
  map.pin = [](Index vertex) { return std::vector<Index>{vertex}; };
  carry_tags(mesh.tags, map, edit);
  return edit;
}

LoopCutPreview loop_cut_preview(const PolyMesh& mesh, const MeshTopology& topology, Index edge, double at) {
  require_edge(topology, edge);
  const EdgeRing ring = walk_ring(topology, edge);
  LoopCutPreview preview;
  preview.closed = ring.closed;
  for (const DirectedEdge& ring_edge : ring.edges) {
    const Vec3& from = mesh.positions[ring_edge.from];
    const Vec3& to = mesh.positions[other_end(topology, ring_edge.edge, ring_edge.from)];
    preview.points.push_back(from + usable_part(at) * (to - from));
  }
  return preview;
}

}  // namespace croquis
