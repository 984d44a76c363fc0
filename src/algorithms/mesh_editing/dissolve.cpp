// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "algorithms/mesh_editing/edge_walk.h"
#include "algorithms/mesh_editing/mesh_rebuild.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/mesh_editing/mesh_edit.h"

namespace croquis {
namespace {

/// Faces that become one, by their corners: the outline in order, as old corners.
struct Union {
  std::vector<Index> faces;
  std::vector<Index> outline;
};

class Dissolver {
 public:
  Dissolver(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> edges)
      : mesh_(mesh), topology_(topology), groups_(topology.face_count()), open_(topology.edge_count(), 0) {
    for (const Index edge : edges) {
      if (edge >= topology.edge_count() || topology.edge_corners(edge).size() != 2) continue;
      const auto corners = topology.edge_corners(edge);
      groups_.unite(topology.face(corners[0]), topology.face(corners[1]));
    }
    unite_faces();
  }

  /// Whether the edge has gone.
  bool open(Index edge) const { return open_[edge] != 0; }

  /// Edges of a vertex that are still there.
  Elements edges_left(Index vertex) const {
    Elements edges = edges_at(topology_, vertex);
    std::erase_if(edges, [&](Index edge) { return open(edge); });
    return edges;
  }

  /// Removes a vertex from all outlines. @return false, with nothing done, when an outline would keep too little
  bool cut_out(Index vertex, bool faces_may_vanish);

  /// @param loose vertices without faces that go, too
  MeshEdit finish(std::span<const Index> loose = {}) const;
  Findings refused() const;

  /// Replaces the two edges at a vertex that goes by the one between its neighbours, where tags are concerned.
  void join_over(Index vertex, Index from, Index to) { joined_[vertex] = {from, to}; }

 private:
  void unite_faces();
  std::optional<std::vector<Index>> outline_of(const std::vector<Index>& faces, Index group);
  Index after(Index corner, Index group);
  TagMap tag_map(const std::vector<Index>& number) const;
  Index stand_in(Index vertex, Index coming_from) const;

  const PolyMesh& mesh_;
  const MeshTopology& topology_;
  DisjointSets groups_;
  std::vector<char> open_;     ///< #E
  std::vector<Union> unions_;  ///< each face in one, ordered by their lowest
  std::vector<std::size_t> union_of_face_;
  std::map<Index, VertexPair> joined_;
  std::size_t refused_ = 0;
};

/// The next corner of a group's outline, no_index where faces disagree about their sides.
Index Dissolver::after(Index corner, Index group) {
  Index next = topology_.next(corner);
  for (std::size_t steps = 0; steps <= topology_.corner_count(); ++steps) {
    const Index across = topology_.opposite(next);
    if (across == no_index || groups_.root(topology_.face(across)) != group) return next;
    if (topology_.vertex(across) == topology_.vertex(next)) return no_index;
    next = topology_.next(across);
  }
  return no_index;
}

std::optional<std::vector<Index>> Dissolver::outline_of(const std::vector<Index>& faces, Index group) {
  std::size_t rim = 0;
  Index first = no_index;
  for (const Index face : faces) {
    for (Index corner = mesh_.face_offsets[face]; corner < mesh_.face_offsets[face + 1]; ++corner) {
      const Index across = topology_.opposite(corner);
      if (across != no_index && groups_.root(topology_.face(across)) == group) continue;
      ++rim;
      if (first == no_index) first = corner;
    }
  }
  std::vector<Index> outline;
  std::set<Index> vertices;
  for (Index corner = first; corner != no_index; corner = after(corner, group)) {
    if (corner == first && !outline.empty()) break;
    if (!vertices.insert(topology_.vertex(corner)).second) return std::nullopt;
    outline.push_back(corner);
  }
  if (outline.size() < 3 || outline.size() != rim || after(outline.back(), group) != first) return std::nullopt;
  return outline;
}

void Dissolver::unite_faces() {
  std::vector<std::vector<Index>> members(topology_.face_count());
  for (Index face = 0; face < members.size(); ++face) members[groups_.root(face)].push_back(face);
  union_of_face_.resize(members.size());
  std::vector<char> fused(members.size(), 0);
  for (Index face = 0; face < members.size(); ++face) {
    const Index group = groups_.root(face);
    const auto& faces = members[group];
    std::optional<std::vector<Index>> outline;
    if (faces.size() > 1 && face == group) {
      outline = outline_of(faces, group);
      fused[group] = outline ? 1 : 0;
      if (!outline) ++refused_;
    }
    if (face != group && fused[group] != 0) continue;  // part of a union listed at its lowest face
    Union united{{face}, {}};
    if (outline) {
      united = {faces, std::move(*outline)};
    } else {
      for (Index c = mesh_.face_offsets[face]; c < mesh_.face_offsets[face + 1]; ++c) united.outline.push_back(c);
    }
    for (const Index member : united.faces) union_of_face_[member] = unions_.size();
    unions_.push_back(std::move(united));
  }
  for (Index edge = 0; edge < open_.size(); ++edge) {
    const auto corners = topology_.edge_corners(edge);
    if (corners.size() != 2) continue;
    const std::size_t a = union_of_face_[topology_.face(corners[0])];
    open_[edge] = a == union_of_face_[topology_.face(corners[1])] && unions_[a].faces.size() > 1 ? 1 : 0;
  }
}

bool Dissolver::cut_out(Index vertex, bool faces_may_vanish) {
  std::set<std::size_t> touched;
  for (const Index corner : topology_.vertex_corners(vertex)) touched.insert(union_of_face_[topology_.face(corner)]);
  const auto has = [&](Index corner) { return topology_.vertex(corner) == vertex; };
  for (const std::size_t i : touched) {
    const auto& outline = unions_[i].outline;
    const auto count = std::count_if(outline.begin(), outline.end(), has);
    if (!faces_may_vanish && outline.size() < 3 + static_cast<std::size_t>(count)) return false;
  }
  for (const std::size_t i : touched) {
    auto& outline = unions_[i].outline;
    std::erase_if(outline, has);
    if (outline.size() < 3) outline.clear();
  }
  return true;
}

/// The vertex at which an edge ends now that starts from `coming_from`: beyond those cut out.
Index Dissolver::stand_in(Index vertex, Index coming_from) const {
  for (auto found = joined_.find(vertex); found != joined_.end(); found = joined_.find(vertex)) {
    const Index onward = found->second[0] == coming_from ? found->second[1] : found->second[0];
    coming_from = std::exchange(vertex, onward);
  }
  return vertex;
}

TagMap Dissolver::tag_map(const std::vector<Index>& number) const {
  TagMap map;
  map.edge = [this, &number](const VertexPair& pair) -> std::vector<VertexPair> {
    const Index edge = find_edge(topology_, pair[0], pair[1]);
    if (edge == no_index || open(edge)) return {};
    const Index a = stand_in(pair[0], pair[1]);
    const Index b = stand_in(pair[1], pair[0]);
    if (a == b || number[a] == no_index || number[b] == no_index) return {};
    return {{number[a], number[b]}};
  };
  map.pin = [this, &number](Index vertex) -> std::vector<Index> {
    if (vertex >= topology_.vertex_count() || number[vertex] == no_index) return {};
    return {number[vertex]};
  };
  return map;
}

MeshEdit Dissolver::finish(std::span<const Index> loose) const {
  MeshPlan plan = plan_with_vertices_of(mesh_);
  for (const Union& united : unions_) {
    if (united.outline.empty()) continue;
    for (const Index corner : united.outline) plan.add_corner(topology_.vertex(corner), {corner, no_index, 0});
    plan.end_face(united.faces.front());
  }
  const std::vector<Index> number = drop_unused_vertices(plan, topology_, loose);
  MeshEdit edit = rebuilt(mesh_, plan, number);
  carry_tags(mesh_.tags, tag_map(number), edit);
  const Findings not_done = refused();
  edit.lost.insert(edit.lost.end(), not_done.begin(), not_done.end());
  return edit;
}

Findings Dissolver::refused() const {
  if (refused_ == 0) return {};
  return {make_warning(Category::Geometry, "W_NOT_DISSOLVED",
                       std::to_string(refused_) +
                           (refused_ == 1 ? " group of faces stays as it is" : " groups of faces stay as they are") +
                           ": one polygon can't have a hole, touch itself or have no rim. Dissolve fewer edges.")};
}

bool on_rim(const MeshTopology& topology, Index vertex) {
  const Elements edges = edges_at(topology, vertex);
  return std::any_of(edges.begin(), edges.end(), [&](Index edge) { return topology.edge_corners(edge).size() != 2; });
}

/// Vertices at an end of a dissolved edge that join only two edges now; the edges' other ends.
std::map<Index, VertexPair> superfluous(const MeshTopology& topology, const Dissolver& dissolver,
                                        std::span<const Index> edges) {
  std::map<Index, VertexPair> found;
  for (const Index edge : edges) {
    if (edge >= topology.edge_count() || !dissolver.open(edge)) continue;
    for (const Index vertex : topology.edge_vertices(edge)) {
      const Elements left = dissolver.edges_left(vertex);
      if (left.size() == 2 && !on_rim(topology, vertex))
        found[vertex] = {other_end(topology, left[0], vertex), other_end(topology, left[1], vertex)};
    }
  }
  return found;
}

/// In a pair, one vertex for another.
void replace(VertexPair& pair, Index from, Index to) {
  if (pair[0] == from) {
    pair[0] = to;
  } else if (pair[1] == from) {
    pair[1] = to;
  }
}

}  // namespace

MeshEdit dissolve_edges(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> edges) {
  Dissolver dissolver(mesh, topology, edges);
  std::map<Index, VertexPair> vertices = superfluous(topology, dissolver, edges);
  std::set<VertexPair> made;
  for (const auto& [vertex, original] : std::map<Index, VertexPair>(vertices)) {
    const auto [from, to] = vertices[vertex];
    const VertexPair joined = ordered_pair(from, to);
    // An edge that is there already would get more than two faces.
    const Index known = find_edge(topology, from, to);
    if (from == to || made.contains(joined) || (known != no_index && !dissolver.open(known))) continue;
    if (!dissolver.cut_out(vertex, false)) continue;
    made.insert(joined);
    dissolver.join_over(vertex, original[0], original[1]);
    if (const auto neighbour = vertices.find(from); neighbour != vertices.end()) replace(neighbour->second, vertex, to);
    if (const auto neighbour = vertices.find(to); neighbour != vertices.end()) replace(neighbour->second, vertex, from);
  }
  return dissolver.finish();
}

MeshEdit dissolve_vertices(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> vertices) {
  const Elements chosen = sorted_unique(Elements(vertices.begin(), vertices.end()));
  Elements edges;
  for (const Index vertex : chosen) {
    if (vertex >= mesh.vertex_count()) continue;
    const Elements around = edges_at(topology, vertex);
    edges.insert(edges.end(), around.begin(), around.end());
  }
  Dissolver dissolver(mesh, topology, edges);
  for (const Index vertex : chosen) {
    if (vertex >= mesh.vertex_count()) continue;
    const Elements left = dissolver.edges_left(vertex);
    const bool free =
        std::all_of(left.begin(), left.end(), [&](Index edge) { return topology.edge_corners(edge).size() == 1; });
    if (free) dissolver.cut_out(vertex, true);
  }
  return dissolver.finish(chosen);
}

}  // namespace croquis
