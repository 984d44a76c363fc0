// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/mesh_editing/mesh_edit.h"

#include <algorithm>
#include <utility>

#include "algorithms/mesh_editing/mesh_rebuild.h"
#include "croquis/base/error.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis {
namespace {

/// New vertices by the old one that they come from.
IndexTable by_source(const std::vector<Index>& sources, std::size_t old_count) {
  IndexTable table;
  table.offsets.assign(old_count + 1, 0);
  for (const Index source : sources) {
    if (source != no_index) ++table.offsets[source + std::size_t{1}];
  }
  for (std::size_t i = 0; i < old_count; ++i) table.offsets[i + 1] += table.offsets[i];
  table.values.resize(table.offsets.back());
  std::vector<Index> place(table.offsets.begin(), table.offsets.end() - 1);
  for (Index i = 0; i < sources.size(); ++i) {
    if (sources[i] != no_index) table.values[place[sources[i]]++] = i;
  }
  return table;
}

/// New edges that run along an old one: between copies of its ends, straight or over one new vertex.
void add_pieces(const MeshEdit& edit, const MeshTopology& after, Index a, Index b, Elements& found) {
  const Index direct = find_edge(after, a, b);
  if (direct != no_index) {
    found.push_back(direct);
    return;
  }
  for (const Index corner : after.vertex_corners(a)) {
    for (const Index middle : {after.vertex(after.next(corner)), after.vertex(after.previous(corner))}) {
      if (edit.vertex_source[middle] != no_index) continue;
      const Index second = find_edge(after, middle, b);
      // A cut's own edges also join new vertices to nothing old, so a path of two edges is the old edge.
      if (second == no_index) continue;
      found.push_back(find_edge(after, a, middle));
      found.push_back(second);
    }
  }
}

}  // namespace

Elements carried(const MeshEdit& edit, const MeshTopology& before, const MeshTopology& after, ComponentKind kind,
                 std::span<const Index> elements) {
  const std::size_t count = element_count(before, kind);
  const bool faces = kind == ComponentKind::Face;
  const IndexTable now =
      by_source(faces ? edit.face_source : edit.vertex_source, faces ? before.face_count() : before.vertex_count());
  Elements found;
  for (const Index element : elements) {
    if (element >= count) continue;
    if (kind != ComponentKind::Edge) {
      found.insert(found.end(), now[element].begin(), now[element].end());
      continue;
    }
    const auto [a, b] = before.edge_vertices(element);
    for (const Index new_a : now[a]) {
      for (const Index new_b : now[b]) add_pieces(edit, after, new_a, new_b, found);
    }
  }
  return sorted_unique(std::move(found));
}

Elements edges_of(const MeshTopology& topology, std::span<const VertexPair> pairs) {
  Elements edges;
  for (const VertexPair& pair : pairs) {
    const Index edge = find_edge(topology, pair[0], pair[1]);
    if (edge != no_index) edges.push_back(edge);
  }
  return sorted_unique(std::move(edges));
}

PolyMesh transformed(PolyMesh mesh, std::span<const Index> vertices, const Eigen::Affine3d& map) {
  for (const Index vertex : vertices) {
    if (vertex < mesh.vertex_count()) mesh.positions[vertex] = map * mesh.positions[vertex];
  }
  if (mesh.channels.empty()) return mesh;
  std::vector<char> moved(mesh.vertex_count(), 0);
  for (const Index vertex : vertices) {
    if (vertex < moved.size()) moved[vertex] = 1;
  }
  forget_normals(mesh, moved);
  return mesh;
}

Vec3 mean_normal(const PolyMesh& mesh, std::span<const Index> faces) {
  Vec3 sum = Vec3::Zero();
  double area = 0;
  for (const Index face : faces) {
    if (face >= mesh.face_count()) continue;
    const Vec3 normal = area_normal(mesh, face);
    sum += normal;
    area += normal.norm();
  }
  constexpr double cancelled = 1e-9;  // of the area: what is left of a closed surface is rounding
  return sum.norm() > cancelled * area ? Vec3(sum.normalized()) : Vec3(Vec3::Zero());
}

MeshEdit delete_faces(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> faces) {
  std::vector<char> gone(mesh.face_count(), 0);
  for (const Index face : faces) {
    if (face < gone.size()) gone[face] = 1;
  }
  MeshPlan plan = plan_with_vertices_of(mesh);
  for (Index face = 0; face < gone.size(); ++face) {
    if (gone[face] == 0) keep_face(plan, mesh, face);
  }
  const std::vector<Index> number = drop_unused_vertices(plan, topology);
  MeshEdit edit = rebuilt(mesh, plan, number);
  TagMap map;
  map.edge = [&](const VertexPair& pair) -> std::vector<VertexPair> {
    const Index edge = find_edge(topology, pair[0], pair[1]);
    if (edge == no_index) return {};
    const auto corners = topology.edge_corners(edge);
    const bool stays =
        std::any_of(corners.begin(), corners.end(), [&](Index c) { return gone[topology.face(c)] == 0; });
    if (!stays) return {};
    return {{number[pair[0]], number[pair[1]]}};
  };
  map.pin = [&](Index vertex) -> std::vector<Index> {
    if (vertex >= topology.vertex_count() || number[vertex] == no_index) return {};
    return {number[vertex]};
  };
  carry_tags(mesh.tags, map, edit);
  return edit;
}

}  // namespace croquis
