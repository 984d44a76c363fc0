// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/mesh_editing/edge_walk.h"

#include <algorithm>
#include <set>
#include <utility>

namespace croquis {
namespace {

/// The face's corner that isn't in `face` of an edge with exactly two, or no_index.
Index corner_beyond(const MeshTopology& topology, Index edge, Index face) {
  const auto corners = topology.edge_corners(edge);
  if (corners.size() != 2) return no_index;
  if (topology.face(corners[0]) == face) return corners[1];
  return topology.face(corners[1]) == face ? corners[0] : no_index;
}

bool is_rim_edge(const MeshTopology& topology, Index edge) { return topology.edge_corners(edge).size() == 1; }

bool share_a_face(const MeshTopology& topology, Index a, Index b) {
  for (const Index corner : topology.edge_corners(a)) {
    for (const Index other : topology.edge_corners(b)) {
      if (topology.face(corner) == topology.face(other)) return true;
    }
  }
  return false;
}

/// Appends ring edges beyond a corner of the last edge until the ring ends or comes back.
bool extend_ring(const MeshTopology& topology, Index corner, EdgeRing& ring, std::set<Index>& edges,
                 std::set<Index>& faces) {
  const Index first = ring.edges.front().edge;
  while (corner != no_index) {
    const auto step = across(topology, ring.edges.back(), corner);
    if (!step || faces.contains(step->face)) return false;
    const bool back = step->edge.edge == first;
    if (!back && !edges.insert(step->edge.edge).second) return false;
    faces.insert(step->face);
    ring.faces.push_back(step->face);
    if (back) return true;
    ring.edges.push_back(step->edge);
    corner = corner_beyond(topology, step->edge.edge, step->face);
  }
  return false;
}

/// The corner that starts an edge in its only face of more than four sides, or no_index.
Index corner_in_cap(const MeshTopology& topology, Index edge) {
  Index cap = no_index;
  for (const Index corner : topology.edge_corners(edge)) {
    int sides = 1;
    for (Index at = topology.next(corner); at != corner; at = topology.next(at)) ++sides;
    if (sides <= 4) continue;
    if (cap != no_index) return no_index;
    cap = corner;
  }
  return cap;
}

/// Around a polygon that closes a tube, where three edges meet.
Index along_cap(const MeshTopology& topology, Index edge, Index vertex) {
  const Index corner = corner_in_cap(topology, edge);
  if (corner == no_index) return no_index;
  const bool starts = topology.vertex(corner) == vertex;
  const Index other = topology.edge(starts ? topology.previous(corner) : topology.next(corner));
  const Index beyond = other == no_index ? no_index : corner_in_cap(topology, other);
  return beyond != no_index && topology.face(beyond) == topology.face(corner) ? other : no_index;
}

}  // namespace

Index other_end(const MeshTopology& topology, Index edge, Index vertex) {
  const auto [a, b] = topology.edge_vertices(edge);
  return a == vertex ? b : a;
}

Elements edges_at(const MeshTopology& topology, Index vertex) {
  Elements edges;
  for (const Index corner : topology.vertex_corners(vertex)) {
    for (const Index starts : {corner, topology.previous(corner)}) {
      if (topology.edge(starts) != no_index) edges.push_back(topology.edge(starts));
    }
  }
  return sorted_unique(std::move(edges));
}

Index straight_on(const MeshTopology& topology, Index edge, Index vertex) {
  if (!topology.is_manifold(vertex)) return no_index;
  const Elements edges = edges_at(topology, vertex);
  const auto rims =
      std::count_if(edges.begin(), edges.end(), [&](Index other) { return is_rim_edge(topology, other); });
  if (rims == 0 && edges.size() == 3) return along_cap(topology, edge, vertex);
  if (rims == 0 && edges.size() != 4) return no_index;
  if (rims != 0 && !is_rim_edge(topology, edge)) return no_index;
  for (const Index other : edges) {
    if (other == edge) continue;
    if (rims != 0 ? is_rim_edge(topology, other) : !share_a_face(topology, edge, other)) return other;
  }
  return no_index;
}

std::optional<RingStep> across(const MeshTopology& topology, const DirectedEdge& edge, Index corner) {
  const Index b = topology.next(corner);
  const Index c = topology.next(b);
  const Index d = topology.next(c);
  if (topology.next(d) != corner || d == corner || c == corner) return std::nullopt;
  if (topology.vertex(corner) == topology.vertex(c) || topology.vertex(b) == topology.vertex(d)) return std::nullopt;
  const Index opposite = topology.edge(c);
  if (opposite == no_index || opposite == edge.edge) return std::nullopt;
  const bool along = topology.vertex(corner) == edge.from;
  return RingStep{topology.face(corner), {opposite, topology.vertex(along ? d : c)}};
}

EdgeRing walk_ring(const MeshTopology& topology, Index edge) {
  EdgeRing ring;
  ring.edges = {{edge, topology.edge_vertices(edge)[0]}};
  const auto corners = topology.edge_corners(edge);
  if (corners.size() > 2) return ring;
  std::set<Index> edges = {edge};
  std::set<Index> faces;
  ring.closed = extend_ring(topology, corners.front(), ring, edges, faces);
  if (ring.closed || corners.size() < 2) return ring;
  EdgeRing other;
  other.edges = {ring.edges.front()};
  extend_ring(topology, corners.back(), other, edges, faces);
  std::reverse(other.edges.begin(), other.edges.end());
  std::reverse(other.faces.begin(), other.faces.end());
  other.edges.insert(other.edges.end(), ring.edges.begin() + 1, ring.edges.end());
  other.faces.insert(other.faces.end(), ring.faces.begin(), ring.faces.end());
  return other;
}

}  // namespace croquis
