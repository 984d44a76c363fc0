// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "algorithms/silhouette/skeleton/axis_graph.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// Joined nodes nearer than this part of the spacing are one place: an edge between them has no useful direction.
constexpr double one_place = 0.05;

using Edges = std::vector<std::array<Index, 2>>;

/// Length of an edge in spacings.
double measure(const AxisGraph& graph, const NodeSpacing& spacing, Index a, Index b) {
  const auto spacing_at = [&](Index node) {
    return std::max(spacing.least, spacing.factor * graph.nodes[node].radius);
  };
  return (graph.nodes[b].position - graph.nodes[a].position).norm() * 2 / (spacing_at(a) + spacing_at(b));
}

/// Nodes from a start along an edge to the next end, junction, or back to the start.
/// @param incident per node: edges
std::vector<Index> follow_branch(const Edges& edges, const std::vector<std::vector<Index>>& incident, Index start,
                                 Index edge, std::vector<bool>& used) {
  std::vector<Index> path{start};
  for (Index node = start; !used[edge];) {
    used[edge] = true;
    node = edges[edge][0] == node ? edges[edge][1] : edges[edge][0];
    path.push_back(node);
    if (node == start || incident[node].size() != 2) break;
    edge = incident[node][0] == edge ? incident[node][1] : incident[node][0];
  }
  return path;
}

/// Nodes of a path that cut it evenly, with both of its ends.
std::vector<Index> cut_evenly(const std::vector<Index>& path, const AxisGraph& graph, const NodeSpacing& spacing) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < path.size(); ++i) {
    along.push_back(along.back() + measure(graph, spacing, path[i - 1], path[i]));
  }
  const std::size_t least = path.front() == path.back() ? 3 : 1;
  const std::size_t pieces = std::max(least, static_cast<std::size_t>(std::lround(along.back())));
  std::vector<Index> cut{path.front()};
  std::size_t last = 0;
  for (std::size_t k = 1; k < pieces; ++k) {
    const double wanted = along.back() * static_cast<double>(k) / static_cast<double>(pieces);
    auto nearest = static_cast<std::size_t>(std::lower_bound(along.begin(), along.end(), wanted) - along.begin());
    if (nearest > 0 && wanted - along[nearest - 1] < along[nearest] - wanted) --nearest;
    if (nearest <= last || nearest + 1 >= path.size()) continue;
    cut.push_back(path[nearest]);
    last = nearest;
  }
  cut.push_back(path.back());
  return cut;
}

/// The graph of the kept nodes and these edges between them, those at one place merged.
AxisGraph compacted(const AxisGraph& graph, const NodeSpacing& spacing, const std::vector<bool>& kept,
                    const Edges& edges) {
  DisjointSets places(graph.nodes.size());
  for (const auto& [a, b] : edges) {
    if (measure(graph, spacing, a, b) < one_place) places.unite(a, b);
  }
  AxisGraph result;
  result.vertex_radius = graph.vertex_radius;
  std::vector<Index> number(graph.nodes.size(), no_index);
  for (Index node = 0; node < graph.nodes.size(); ++node) {
    if (!kept[node]) continue;
    const Index first = places.root(node);
    if (first == node) {
      number[node] = static_cast<Index>(result.nodes.size());
      result.nodes.push_back(graph.nodes[node]);
    } else {
      number[node] = number[first];
      auto& absorbed = result.nodes[number[first]].absorbed;
      absorbed.insert(absorbed.end(), graph.nodes[node].absorbed.begin(), graph.nodes[node].absorbed.end());
    }
  }
  for (const auto& [a, b] : edges) {
    const auto [low, high] = std::minmax({number[a], number[b]});
    if (low != high) result.edges.push_back({low, high});
  }
  std::sort(result.edges.begin(), result.edges.end());
  result.edges.erase(std::unique(result.edges.begin(), result.edges.end()), result.edges.end());
  return result;
}

}  // namespace

AxisGraph decimate(const AxisGraph& graph, const NodeSpacing& spacing) {
  std::vector<std::vector<Index>> incident(graph.nodes.size());
  for (Index e = 0; e < graph.edges.size(); ++e) {
    for (const Index node : graph.edges[e]) incident[node].push_back(e);
  }
  std::vector<bool> used(graph.edges.size(), false), kept(graph.nodes.size(), false);
  Edges edges;
  const auto cut_branch = [&](Index start, Index edge) {
    if (used[edge]) return;
    const std::vector<Index> path = follow_branch(graph.edges, incident, start, edge, used);
    const std::vector<Index> cut = cut_evenly(path, graph, spacing);
    for (std::size_t i = 1; i < cut.size(); ++i) edges.push_back({cut[i - 1], cut[i]});
    for (const Index node : cut) kept[node] = true;
  };
  for (Index node = 0; node < graph.nodes.size(); ++node) {
    if (incident[node].size() == 2) continue;
    kept[node] = true;
    for (const Index edge : incident[node]) cut_branch(node, edge);
  }
  // What is left are loops without an end or a junction.
  for (Index edge = 0; edge < graph.edges.size(); ++edge) cut_branch(graph.edges[edge][0], edge);
  return compacted(graph, spacing, kept, edges);
}

}  // namespace croquis::silhouette
