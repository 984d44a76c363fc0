// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/edge_middles.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis::silhouette {
namespace {

/// @param v      corners of a triangle
/// @param middle of the edges that begin at them, or no_index
void add_cut(const std::array<Index, 3>& v, const std::array<Index, 3>& middle, PolyMesh& mesh) {
  std::vector<Index> rest;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index before = middle[(i + 2) % 3], after = middle[i];
    if (before != no_index && after != no_index) mesh.add_triangle(before, v[i], after);
    if (before == no_index || after == no_index) rest.push_back(v[i]);
    if (after != no_index) rest.push_back(after);
  }
  if (rest.size() == 4) {
    const auto length = [&](std::size_t i) { return (mesh.positions[rest[i]] - mesh.positions[rest[i + 2]]).norm(); };
    const bool is_only = std::ranges::count(middle, no_index) == 2;  // then it is joined to the corner across from it
    const bool is_odd = is_only ? middle[1] == no_index : length(1) < length(0);
    if (is_odd) std::rotate(rest.begin(), rest.begin() + 1, rest.end());
    mesh.add_triangle(rest[0], rest[2], rest[3]);
  }
  mesh.add_triangle(rest[0], rest[1], rest[2]);
}

}  // namespace

bool cut_edges(PolyMesh& mesh, const std::function<bool(Index face, const Vec3& a, const Vec3& b)>& cuts) {
  const MeshTopology topology(mesh);
  std::vector<Index> middle(topology.edge_count(), no_index);
  PolyMesh cut;
  cut.positions = mesh.positions;
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    Index& vertex = middle[topology.edge(corner)];
    const Vec3& a = mesh.positions[topology.vertex(corner)];
    const Vec3& b = mesh.positions[topology.vertex(topology.next(corner))];
    if (vertex != no_index || !cuts(topology.face(corner), a, b)) continue;
    vertex = static_cast<Index>(cut.positions.size());
    cut.positions.emplace_back((a + b) / 2);
  }
  if (cut.positions.size() == mesh.positions.size()) return false;
  std::vector<Index> origin;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto middle_of = [&](Index corner) { return middle[topology.edge(3 * f + corner)]; };
    const auto v = mesh.face(f);
    add_cut({v[0], v[1], v[2]}, {middle_of(0), middle_of(1), middle_of(2)}, cut);
    origin.resize(cut.face_count(), f);
  }
  for (const AttributeChannel& channel : mesh.channels) cut.channels.push_back(gathered(channel, origin));
  mesh = std::move(cut);
  return true;
}

}  // namespace croquis::silhouette
