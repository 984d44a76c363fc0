// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <set>
#include <utility>

#include "algorithms/mesh_editing/edge_walk.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/mesh_editing/mesh_selection.h"
#include "croquis/mesh_editing/tag_edit.h"

namespace croquis {
namespace {

Elements in_order_or_sorted(Elements elements, bool ordered) {
  return ordered ? elements : sorted_unique(std::move(elements));
}

/// Goes on from an edge over a vertex while `next` names an edge that wasn't there before.
template <typename Next>
Elements walk(const MeshTopology& topology, Index edge, Index over, std::set<Index>& seen, Next next) {
  Elements way;
  for (Index at = next(edge, over); at != no_index && seen.insert(at).second; at = next(at, over)) {
    way.push_back(at);
    over = other_end(topology, at, over);
  }
  return way;
}

/// The row of edges through an edge, in order.
template <typename Next>
Elements walk_both_ways(const MeshTopology& topology, Index edge, Next next) {
  const auto [back, front] = topology.edge_vertices(edge);
  std::set<Index> seen = {edge};
  const Elements ahead = walk(topology, edge, front, seen, next);
  Elements row = walk(topology, edge, back, seen, next);
  std::reverse(row.begin(), row.end());
  row.push_back(edge);
  row.insert(row.end(), ahead.begin(), ahead.end());
  return row;
}

/// Where a row of edges ends: of its last edge the vertex that the one before doesn't have.
Index last_vertex(const MeshTopology& topology, std::span<const Index> row) {
  const auto [a, b] = topology.edge_vertices(row.back());
  const auto before = topology.edge_vertices(row[row.size() - 2]);
  return a == before[0] || a == before[1] ? b : a;
}

/// Shortest paths from some vertices (Dijkstra 1959), as far as the first of others.
class ShortestWay {
 public:
  ShortestWay(const MeshTopology& topology, std::span<const Vec3> positions)
      : topology_(topology),
        positions_(positions),
        length_(topology.vertex_count(), std::numeric_limits<double>::infinity()),
        edge_(topology.vertex_count(), no_index) {}

  /// Edges of the path, from its end to its beginning; nothing when there is none.
  std::optional<Elements> find(std::span<const Index> from, std::span<const Index> to) {
    for (const Index vertex : from) reach(vertex, 0, no_index);
    while (!queue_.empty()) {
      const auto [length, vertex] = queue_.top();
      queue_.pop();
      if (length > length_[vertex]) continue;
      if (std::find(to.begin(), to.end(), vertex) != to.end()) return way_to(vertex);
      for (const Index edge : edges_at(topology_, vertex)) {
        const Index other = other_end(topology_, edge, vertex);
        reach(other, length + (positions_[other] - positions_[vertex]).norm(), edge);
      }
    }
    return std::nullopt;
  }

 private:
  void reach(Index vertex, double length, Index edge) {
    if (!(length < length_[vertex])) return;
    length_[vertex] = length;
    edge_[vertex] = edge;
    queue_.emplace(length, vertex);
  }

  Elements way_to(Index vertex) const {
    Elements way;
    while (edge_[vertex] != no_index) {
      way.push_back(edge_[vertex]);
      vertex = other_end(topology_, edge_[vertex], vertex);
    }
    return way;
  }

  using Reached = std::pair<double, Index>;
  const MeshTopology& topology_;
  std::span<const Vec3> positions_;
  std::vector<double> length_;
  std::vector<Index> edge_;  ///< by which each vertex was reached
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue_;
};

/// Degrees between the normals of the faces at an edge of exactly two faces.
double degrees_between(const MeshTopology& topology, Index edge, const Vec3& normal, const Vec3& other) {
  const auto corners = topology.edge_corners(edge);
  const bool same_way = topology.vertex(corners[0]) == topology.vertex(corners[1]);
  const Vec3 turned = same_way ? Vec3(-other) : other;
  if (normal.isZero(0) || other.isZero(0)) return 0;
  return std::atan2(normal.cross(turned).norm(), normal.dot(turned)) * 180 / std::numbers::pi;
}

}  // namespace

// ---- Rows

Elements edge_loop(const MeshTopology& topology, Index edge, bool ordered) {
  if (edge >= topology.edge_count()) return {};
  Elements row = walk_both_ways(topology, edge, [&](Index at, Index over) { return straight_on(topology, at, over); });
  return in_order_or_sorted(std::move(row), ordered);
}

Elements edge_ring(const MeshTopology& topology, Index edge, bool ordered) {
  if (edge >= topology.edge_count()) return {};
  Elements edges;
  for (const DirectedEdge& directed : walk_ring(topology, edge).edges) edges.push_back(directed.edge);
  return in_order_or_sorted(std::move(edges), ordered);
}

bool closes(const MeshTopology& topology, std::span<const Index> loop) {
  if (loop.size() < 3) return false;
  return straight_on(topology, loop.back(), last_vertex(topology, loop)) == loop.front();
}

bool ring_closes(const MeshTopology& topology, std::span<const Index> ring) {
  return !ring.empty() && walk_ring(topology, ring.front()).closed;
}

Elements part_between(std::span<const Index> ordered, Index from, Index to, bool closed) {
  const auto place_of = [&](Index element) {
    return static_cast<std::size_t>(std::find(ordered.begin(), ordered.end(), element) - ordered.begin());
  };
  const auto [first, last] = std::minmax({place_of(from), place_of(to)});
  if (last >= ordered.size()) return {};
  const std::size_t inside = last - first + 1;
  Elements part;
  if (closed && ordered.size() - inside + 2 < inside) {
    part.assign(ordered.begin() + static_cast<std::ptrdiff_t>(last), ordered.end());
    part.insert(part.end(), ordered.begin(), ordered.begin() + static_cast<std::ptrdiff_t>(first) + 1);
  } else {
    part.assign(ordered.begin() + static_cast<std::ptrdiff_t>(first),
                ordered.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  }
  return sorted_unique(std::move(part));
}

// ---- Paths

Elements shortest_path(const MeshTopology& topology, std::span<const Vec3> positions, Index from, Index to) {
  if (from >= topology.vertex_count() || to >= topology.vertex_count()) return {};
  const auto way = ShortestWay(topology, positions).find({{from}}, {{to}});
  return way ? sorted_unique(*way) : Elements{};
}

Elements shortest_edge_path(const MeshTopology& topology, std::span<const Vec3> positions, Index from, Index to) {
  if (from >= topology.edge_count() || to >= topology.edge_count()) return {};
  auto way = ShortestWay(topology, positions).find(topology.edge_vertices(from), topology.edge_vertices(to));
  if (!way) return {};
  way->push_back(from);
  way->push_back(to);
  return sorted_unique(std::move(*way));
}

// ---- Shape and tags

Elements edges_sharper_than(const MeshTopology& topology, const PolyMesh& mesh, double degrees) {
  std::vector<Vec3> normals(topology.face_count());
  for (Index face = 0; face < normals.size(); ++face) normals[face] = area_normal(mesh, face);
  Elements edges;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto corners = topology.edge_corners(edge);
    if (corners.size() != 2) continue;
    const Vec3& normal = normals[topology.face(corners[0])];
    if (degrees_between(topology, edge, normal, normals[topology.face(corners[1])]) > degrees) edges.push_back(edge);
  }
  return edges;
}

Elements tagged_chain(const MeshTopology& topology, const MeshTags& tags, Index edge) {
  if (edge >= topology.edge_count()) return {};
  const Elements tagged = tagged_edges(tags, topology);
  const std::set<Index> pins(tags.pins.begin(), tags.pins.end());
  const auto is_tagged = [&](Index other) { return std::binary_search(tagged.begin(), tagged.end(), other); };
  if (!is_tagged(edge)) return {edge};
  const auto next = [&](Index at, Index over) {
    if (pins.contains(over)) return no_index;
    Index found = no_index;
    for (const Index other : edges_at(topology, over)) {
      if (other == at || !is_tagged(other)) continue;
      if (found != no_index) return no_index;
      found = other;
    }
    return found;
  };
  return sorted_unique(walk_both_ways(topology, edge, next));
}

}  // namespace croquis
