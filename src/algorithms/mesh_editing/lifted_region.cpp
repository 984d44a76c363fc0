// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/mesh_editing/lifted_region.h"

#include <algorithm>

namespace croquis {

LiftedRegion::LiftedRegion(const MeshTopology& topology, std::span<const Index> faces)
    : topology_(topology), lifted_(topology.face_count(), 0), umbrellas_(topology.corner_count()) {
  for (const Index face : faces) {
    if (face < lifted_.size()) lifted_[face] = 1;
  }
  join_corners();
  find_rims();
}

bool LiftedRegion::empty() const {
  return std::none_of(lifted_.begin(), lifted_.end(), [](char lifted) { return lifted != 0; });
}

bool LiftedRegion::on_rim(Index corner) const {
  const Index edge = topology_.edge(corner);
  if (edge == no_index) return false;
  const auto corners = topology_.edge_corners(edge);
  return corners.size() == 1 ||
         std::any_of(corners.begin(), corners.end(), [&](Index other) { return !lifts(topology_.face(other)); });
}

void LiftedRegion::join_corners() {
  for (Index edge = 0; edge < topology_.edge_count(); ++edge) {
    const auto corners = topology_.edge_corners(edge);
    if (on_rim(corners.front())) continue;
    for (const Index corner : corners.subspan(1)) join(corners.front(), corner);
  }
}

/// Two corners that start the same edge: at each of its ends.
void LiftedRegion::join(Index a, Index b) {
  const bool same_way = topology_.vertex(a) == topology_.vertex(b);
  umbrellas_.unite(a, same_way ? b : topology_.next(b));
  umbrellas_.unite(topology_.next(a), same_way ? topology_.next(b) : b);
}

/// An umbrella parts at the border of the lifted faces, or when other faces share its vertex.
void LiftedRegion::find_rims() {
  for (Index corner = 0; corner < topology_.corner_count(); ++corner) {
    if (!lifts(topology_.face(corner))) continue;
    if (on_rim(corner)) {
      parts_.insert(umbrella(corner));
      parts_.insert(umbrella(topology_.next(corner)));
    }
    for (const Index other : topology_.vertex_corners(topology_.vertex(corner)))
      if (umbrella(other) != umbrella(corner)) parts_.insert(umbrella(corner));
  }
}

namespace {

LiftedVertices lift_vertices(const MeshTopology& topology, LiftedRegion& region, MeshPlan& plan) {
  LiftedVertices lifted;
  lifted.vertex.resize(topology.corner_count());
  lifted.above.resize(topology.vertex_count());
  std::vector<Index> of_umbrella(topology.corner_count(), no_index);
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    const Index vertex = topology.vertex(corner);
    lifted.vertex[corner] = vertex;
    if (!region.lifts(topology.face(corner))) continue;
    Index& now = of_umbrella[region.umbrella(corner)];
    if (now == no_index) {
      now = vertex;
      if (region.parts(corner)) {
        now = static_cast<Index>(plan.vertices.size());
        plan.vertices.push_back({vertex, no_index, 0});
      }
      lifted.moved.push_back(now);
      lifted.above[vertex].push_back(now);
    }
    lifted.vertex[corner] = now;
  }
  return lifted;
}

void add_faces(MeshPlan& plan, const PolyMesh& mesh, const std::vector<Index>& vertex_of_corner) {
  for (Index face = 0; face < mesh.face_count(); ++face) {
    for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + 1]; ++corner)
      plan.add_corner(vertex_of_corner[corner], {corner, no_index, 0});
    plan.end_face(face);
  }
}

void add_walls(MeshPlan& plan, const MeshTopology& topology, const LiftedRegion& region,
               const std::vector<Index>& vertex_of_corner) {
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    if (!region.lifts(topology.face(corner)) || !region.on_rim(corner)) continue;
    const Index next = topology.next(corner);
    const Blend at_corner{corner, no_index, 0};
    const Blend at_next{next, no_index, 0};
    plan.add_corner(topology.vertex(corner), at_corner);
    plan.add_corner(topology.vertex(next), at_next);
    plan.add_corner(vertex_of_corner[next], at_next);
    plan.add_corner(vertex_of_corner[corner], at_corner);
    plan.end_face(topology.face(corner));
  }
}

TagMap tags_of_lifted(const MeshTopology& topology, const LiftedRegion& region, const LiftedVertices& lifted) {
  TagMap map;
  map.edge = [&](const VertexPair& pair) -> std::vector<VertexPair> {
    const Index edge = find_edge(topology, pair[0], pair[1]);
    std::vector<VertexPair> pairs;
    if (edge == no_index) return {pair};
    for (const Index corner : topology.edge_corners(edge)) {
      if (!region.lifts(topology.face(corner))) continue;
      const VertexPair above = ordered_pair(lifted.vertex[corner], lifted.vertex[topology.next(corner)]);
      if (std::find(pairs.begin(), pairs.end(), above) == pairs.end()) pairs.push_back(above);
    }
    return pairs.empty() ? std::vector<VertexPair>{pair} : pairs;
  };
  map.pin = [&](Index vertex) -> std::vector<Index> {
    if (vertex >= lifted.above.size()) return {};
    return lifted.above[vertex].empty() ? std::vector<Index>{vertex} : lifted.above[vertex];
  };
  return map;
}

/// Vertices that went, and those whose surroundings have other faces now.
std::vector<char> changed_vertices(const LiftedVertices& lifted, std::size_t old_count, std::size_t count) {
  std::vector<char> changed(count, 0);
  for (const Index vertex : lifted.moved) changed[vertex] = 1;
  for (std::size_t vertex = 0; vertex < old_count; ++vertex) {
    if (!lifted.above[vertex].empty()) changed[vertex] = 1;
  }
  return changed;
}

}  // namespace

LiftedMesh lift_region(const PolyMesh& mesh, const MeshTopology& topology, LiftedRegion& region) {
  MeshPlan plan = plan_with_vertices_of(mesh);
  LiftedVertices vertices = lift_vertices(topology, region, plan);
  add_faces(plan, mesh, vertices.vertex);
  add_walls(plan, topology, region, vertices.vertex);
  MeshEdit edit = rebuilt(mesh, plan, all_elements(mesh.vertex_count()));
  for (auto wall = static_cast<Index>(mesh.face_count()); wall < edit.mesh.face_count(); ++wall) {
    edit.face_source[wall] = no_index;
    edit.new_faces.push_back(wall);
  }
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (region.lifts(face)) edit.moved_faces.push_back(face);
  }
  forget_normals(edit.mesh, changed_vertices(vertices, mesh.vertex_count(), edit.mesh.vertex_count()));
  carry_tags(mesh.tags, tags_of_lifted(topology, region, vertices), edit);
  return {std::move(edit), std::move(vertices)};
}

}  // namespace croquis
