// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/mesh_topology.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"
#include "geometry/boundary_walk.h"

namespace croquis {
namespace {

void require_indices_in_range(const PolyMesh& mesh) {
  const auto& offsets = mesh.face_offsets;
  const bool usable =
      !offsets.empty() && offsets.front() == 0 && offsets.back() == mesh.corners.size() &&
      std::is_sorted(offsets.begin(), offsets.end()) &&
      std::all_of(mesh.corners.begin(), mesh.corners.end(), [&](Index vertex) { return vertex < mesh.vertex_count(); });
  if (usable) return;
  Findings findings = validate(mesh);
  std::erase_if(findings, [](const Finding& finding) { return finding.code != "E_INDEX"; });
  throw Error(std::move(findings));
}

/// Lists the items 0 … keys.size()-1 by key, ascending in each list (counting sort); no_index keys are left out.
IndexTable group_by(const std::vector<Index>& keys, std::size_t key_count) {
  IndexTable table;
  // Shifted by two, so that placing the items turns beginnings into ends.
  table.offsets.assign(key_count + 2, 0);
  for (const Index key : keys) {
    if (key != no_index) ++table.offsets[key + std::size_t{2}];
  }
  std::partial_sum(table.offsets.begin(), table.offsets.end(), table.offsets.begin());
  table.values.resize(table.offsets.back());
  for (Index item = 0; item < keys.size(); ++item) {
    if (keys[item] != no_index) table.values[table.offsets[keys[item] + std::size_t{1}]++] = item;
  }
  table.offsets.pop_back();
  return table;
}

bool are_all_triangles(const std::vector<Index>& face_offsets) {
  for (std::size_t face = 0; face < face_offsets.size(); ++face) {
    if (face_offsets[face] != 3 * face) return false;
  }
  return true;
}

std::vector<Index> faces_of_corners(const std::vector<Index>& face_offsets, std::size_t corner_count) {
  std::vector<Index> faces(corner_count);
  for (Index face = 0; face + std::size_t{1} < face_offsets.size(); ++face) {
    std::fill(faces.begin() + face_offsets[face], faces.begin() + face_offsets[face + 1], face);
  }
  return faces;
}

/// Numbers sets by their first members. @param firsts per item the first of its set; no_index stays
/// @return number of sets
std::size_t number_by_firsts(std::vector<Index>& firsts) {
  Index count = 0;
  for (Index item = 0; item < firsts.size(); ++item) {
    if (firsts[item] == no_index) continue;
    firsts[item] = firsts[item] == item ? count++ : firsts[firsts[item]];  // the first has its number already
  }
  return count;
}

/// An edge as seen from its low end, of one corner that starts it.
struct EdgeUse {
  Index high;  ///< end
  Index corner;
};

/// For each corner the lowest corner that starts the same edge, or no_index. Asks for corners of faces and vertices.
/// Which end of an edge is the low one nothing predicts, so that nothing branches on it.
std::vector<Index> lowest_corner_of_edge(const MeshTopology& topology) {
  std::vector<Index> lowest(topology.corner_count(), no_index);
  std::vector<Index> first(topology.vertex_count(), no_index);  // by high end, for one low end at a time
  std::vector<EdgeUse> uses;
  for (Index vertex = 0; vertex < topology.vertex_count(); ++vertex) {
    const auto corners = topology.vertex_corners(vertex);
    uses.resize(std::max(uses.size(), 2 * corners.size()));
    std::size_t count = 0;
    for (const Index corner : corners) {
      const Index before = topology.previous(corner);
      uses[count] = {topology.vertex(topology.next(corner)), corner};
      count += uses[count].high > vertex ? 1U : 0U;
      uses[count] = {topology.vertex(before), before};
      count += uses[count].high > vertex ? 1U : 0U;
    }
    const std::span<const EdgeUse> edges(uses.data(), count);
    for (const auto& [high, corner] : edges) first[high] = std::min(first[high], corner);
    for (const auto& [high, corner] : edges) lowest[corner] = first[high];
    for (const auto& [high, corner] : edges) first[high] = no_index;
  }
  return lowest;
}

/// Faces joined across edges.
DisjointSets components_of(const MeshTopology& topology) {
  DisjointSets components(topology.face_count());
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto corners = topology.edge_corners(edge);
    for (const Index corner : corners.subspan(1))
      components.unite(topology.face(corners.front()), topology.face(corner));
  }
  return components;
}

}  // namespace

MeshTopology::MeshTopology(const PolyMesh& mesh) {
  require_indices_in_range(mesh);
  face_offsets_ = mesh.face_offsets;
  corner_vertex_ = mesh.corners;
  is_of_triangles_ = are_all_triangles(face_offsets_);
  corner_face_ = faces_of_corners(face_offsets_, corner_vertex_.size());
  vertex_corners_ = group_by(corner_vertex_, mesh.vertex_count());

  corner_edge_ = lowest_corner_of_edge(*this);
  edge_corners_ = group_by(corner_edge_, number_by_firsts(corner_edge_));

  number_fans();

  component_count_ = components_of(*this).number(face_component_);

  boundary_loops_ = trace_boundary_loops(*this);
}

void MeshTopology::number_fans() {
  fans_of_vertex_.assign(vertex_corners_.size(), 0);
  corner_fan_.assign(corner_vertex_.size(), no_index);
  std::vector<Index> pending;
  for (Index vertex = 0; vertex < vertex_count(); ++vertex) {
    const auto enter = [&](Index corner) {
      if (corner_fan_[corner] != no_index) return;
      corner_fan_[corner] = fans_of_vertex_[vertex];
      pending.push_back(corner);
    };
    for (const Index first : vertex_corners_[vertex]) {
      if (corner_fan_[first] != no_index) continue;
      enter(first);
      while (!pending.empty()) {
        const Index corner = pending.back();
        pending.pop_back();
        for (const Index starts : {corner, previous(corner)}) {
          if (corner_edge_[starts] == no_index)  // the face repeats the vertex
            enter(starts == corner ? next(corner) : starts);
          else if (const Index other = opposite(starts); other != no_index)
            enter(corner_vertex_[other] == vertex ? other : next(other));
        }
      }
      ++fans_of_vertex_[vertex];
    }
  }
}

std::array<Index, 2> MeshTopology::edge_vertices(Index edge) const {
  const Index corner = edge_corners_[edge].front();
  return {vertex(corner), vertex(next(corner))};
}

bool MeshTopology::is_manifold(Index vertex) const {
  if (fans_of_vertex_[vertex] > 1) return false;
  for (const Index corner : vertex_corners_[vertex]) {
    for (const Index starts : {corner, previous(corner)}) {
      if (edge(starts) != no_index && edge_corners(edge(starts)).size() > 2) return false;
    }
  }
  return true;
}

}  // namespace croquis
