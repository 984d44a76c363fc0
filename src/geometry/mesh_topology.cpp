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
  table.offsets.assign(key_count + 1, 0);
  for (const Index key : keys) {
    if (key != no_index) ++table.offsets[key + std::size_t{1}];
  }
  std::partial_sum(table.offsets.begin(), table.offsets.end(), table.offsets.begin());
  table.values.resize(table.offsets.back());
  std::vector<Index> free_place(table.offsets.begin(), table.offsets.end() - 1);
  for (Index item = 0; item < keys.size(); ++item) {
    if (keys[item] != no_index) table.values[free_place[keys[item]]++] = item;
  }
  return table;
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

/// The lower and the higher vertex of the edge that each corner starts; no_index where it starts none.
struct EdgeEnds {
  explicit EdgeEnds(const PolyMesh& mesh) : low(mesh.corners.size(), no_index), high(mesh.corners.size(), no_index) {
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
      const Index end = mesh.face_offsets[face + 1];
      for (Index corner = mesh.face_offsets[face]; corner < end; ++corner) {
        const Index next = corner + 1 == end ? mesh.face_offsets[face] : corner + 1;
        if (mesh.corners[corner] == mesh.corners[next]) continue;
        low[corner] = std::min(mesh.corners[corner], mesh.corners[next]);
        high[corner] = std::max(mesh.corners[corner], mesh.corners[next]);
      }
    }
  }

  std::vector<Index> low, high;
};

/// Up to so many edges from one vertex are compared all with all; beyond they are sorted.
constexpr std::size_t most_to_compare = 16;

/// Of corners with the same low end, ascending: the lowest with each high end.
void match_high_ends(std::span<const Index> corners, const std::vector<Index>& high, std::vector<Index>& lowest) {
  if (corners.size() <= most_to_compare) {
    for (const Index corner : corners)
      lowest[corner] = *std::ranges::find_if(corners, [&](Index other) { return high[other] == high[corner]; });
    return;
  }
  std::vector<Index> sorted(corners.begin(), corners.end());
  std::stable_sort(sorted.begin(), sorted.end(), [&](Index a, Index b) { return high[a] < high[b]; });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const bool same = i > 0 && high[sorted[i - 1]] == high[sorted[i]];
    lowest[sorted[i]] = same ? lowest[sorted[i - 1]] : sorted[i];
  }
}

/// For each corner the lowest corner that starts the same edge.
std::vector<Index> lowest_corner_of_edge(const PolyMesh& mesh) {
  const EdgeEnds ends(mesh);
  const IndexTable by_low_end = group_by(ends.low, mesh.vertex_count());
  std::vector<Index> lowest(mesh.corners.size(), no_index);
  for (std::size_t vertex = 0; vertex < by_low_end.size(); ++vertex)
    match_high_ends(by_low_end[vertex], ends.high, lowest);
  return lowest;
}

/// The corners at an edge's two ends that belong to the face of `corner`, the one at vertex `first` in front.
std::pair<Index, Index> end_corners(const MeshTopology& topology, Index corner, Index first) {
  const Index next = topology.next(corner);
  return topology.vertex(corner) == first ? std::pair(corner, next) : std::pair(next, corner);
}

/// For each corner the lowest corner of its fan.
std::vector<Index> lowest_corner_of_fan(const MeshTopology& topology) {
  DisjointSets fans(topology.corner_count());
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    if (topology.edge(corner) == no_index) fans.unite(corner, topology.next(corner));
  }
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto corners = topology.edge_corners(edge);
    if (corners.size() != 2) continue;
    const auto [a, b] = end_corners(topology, corners[0], topology.vertex(corners[0]));
    const auto [other_a, other_b] = end_corners(topology, corners[1], topology.vertex(corners[0]));
    fans.unite(a, other_a);
    fans.unite(b, other_b);
  }
  return fans.take_roots();
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
  corner_face_ = faces_of_corners(face_offsets_, corner_vertex_.size());
  vertex_corners_ = group_by(corner_vertex_, mesh.vertex_count());

  corner_edge_ = lowest_corner_of_edge(mesh);
  edge_corners_ = group_by(corner_edge_, number_by_firsts(corner_edge_));

  corner_fan_ = lowest_corner_of_fan(*this);
  number_fans();

  component_count_ = components_of(*this).number(face_component_);

  boundary_loops_ = trace_boundary_loops(*this);
}

void MeshTopology::number_fans() {
  fans_of_vertex_.assign(vertex_corners_.size(), 0);
  for (Index corner = 0; corner < corner_fan_.size(); ++corner) {
    const Index lowest = corner_fan_[corner];  // at or before `corner`, so already numbered if before
    corner_fan_[corner] = lowest == corner ? fans_of_vertex_[corner_vertex_[corner]]++ : corner_fan_[lowest];
  }
}

Index MeshTopology::next(Index corner) const {
  const Index face = corner_face_[corner];
  return corner + 1 == face_offsets_[face + 1] ? face_offsets_[face] : corner + 1;
}

Index MeshTopology::previous(Index corner) const {
  const Index face = corner_face_[corner];
  return corner == face_offsets_[face] ? face_offsets_[face + 1] - 1 : corner - 1;
}

std::array<Index, 2> MeshTopology::edge_vertices(Index edge) const {
  const Index corner = edge_corners_[edge].front();
  return {vertex(corner), vertex(next(corner))};
}

Index MeshTopology::opposite(Index corner) const {
  if (corner_edge_[corner] == no_index) return no_index;
  const auto corners = edge_corners_[corner_edge_[corner]];
  if (corners.size() != 2) return no_index;
  return corners.front() == corner ? corners.back() : corners.front();
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
