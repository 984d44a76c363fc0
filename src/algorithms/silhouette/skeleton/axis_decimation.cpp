// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/axis_decimation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace croquis::silhouette {
namespace {

/// Joined nodes nearer than this part of the spacing are one place: an edge between them has no useful direction.
constexpr double one_place = 0.05;

class Decimator {
 public:
  Decimator(const AxisGraph& graph, const NodeSpacing& spacing)
      : graph_(graph),
        spacing_(spacing),
        incident_(graph.nodes.size()),
        used_(graph.edges.size(), false),
        kept_(graph.nodes.size(), false) {
    for (Index e = 0; e < graph.edges.size(); ++e) {
      for (const Index node : graph.edges[e]) incident_[node].push_back(e);
    }
  }

  AxisGraph decimate() {
    for (Index node = 0; node < graph_.nodes.size(); ++node) {
      if (incident_[node].size() == 2) continue;
      kept_[node] = true;
      for (const Index edge : incident_[node]) cut_branch(node, edge);
    }
    // What is left are loops without an end or a junction.
    for (Index edge = 0; edge < graph_.edges.size(); ++edge) cut_branch(graph_.edges[edge][0], edge);
    merge_close_nodes();
    return compacted();
  }

 private:
  double spacing_at(Index node) const { return std::max(spacing_.least, spacing_.factor * graph_.nodes[node].radius); }

  /// Length of an edge in spacings.
  double measure(Index a, Index b) const {
    return (graph_.nodes[b].position - graph_.nodes[a].position).norm() * 2 / (spacing_at(a) + spacing_at(b));
  }

  Index other_end(Index edge, Index node) const {
    const auto& [a, b] = graph_.edges[edge];
    return a == node ? b : a;
  }

  /// Nodes from a start along an edge to the next end, junction, or back to the start.
  std::vector<Index> follow(Index start, Index edge) {
    std::vector<Index> path{start};
    for (Index node = start; !used_[edge];) {
      used_[edge] = true;
      node = other_end(edge, node);
      path.push_back(node);
      if (node == start || incident_[node].size() != 2) break;
      edge = incident_[node][0] == edge ? incident_[node][1] : incident_[node][0];
    }
    return path;
  }

  void cut_branch(Index start, Index edge) {
    if (used_[edge]) return;
    const std::vector<Index> path = follow(start, edge);
    std::vector<double> along{0};
    for (std::size_t i = 1; i < path.size(); ++i) along.push_back(along.back() + measure(path[i - 1], path[i]));
    const std::size_t least = path.front() == path.back() ? 3 : 1;
    const std::size_t pieces = std::max(least, static_cast<std::size_t>(std::lround(along.back())));
    std::size_t last = 0;
    for (std::size_t k = 1; k < pieces; ++k) {
      const double wanted = along.back() * static_cast<double>(k) / static_cast<double>(pieces);
      const std::size_t nearest = nearest_to(along, wanted);
      if (nearest <= last || nearest + 1 >= path.size()) continue;
      connect(path[last], path[nearest]);
      last = nearest;
    }
    connect(path[last], path.back());
  }

  static std::size_t nearest_to(const std::vector<double>& along, double wanted) {
    const auto after = std::lower_bound(along.begin(), along.end(), wanted);
    const auto i = static_cast<std::size_t>(after - along.begin());
    return i > 0 && wanted - along[i - 1] < along[i] - wanted ? i - 1 : i;
  }

  void connect(Index a, Index b) {
    kept_[a] = kept_[b] = true;
    edges_.push_back({a, b});
  }

  void merge_close_nodes() {
    representative_.resize(graph_.nodes.size());
    std::iota(representative_.begin(), representative_.end(), Index{0});
    for (const auto& [a, b] : edges_) {
      if (measure(a, b) >= one_place) continue;
      const Index low = std::min(representative_[a], representative_[b]);
      const Index high = std::max(representative_[a], representative_[b]);
      std::replace(representative_.begin(), representative_.end(), high, low);
    }
  }

  AxisGraph compacted() const {
    AxisGraph result;
    result.vertex_radius = graph_.vertex_radius;
    std::vector<Index> number(graph_.nodes.size(), no_index);
    for (Index node = 0; node < graph_.nodes.size(); ++node) {
      if (!kept_[node] || representative_[node] != node) continue;
      number[node] = static_cast<Index>(result.nodes.size());
      result.nodes.push_back(graph_.nodes[node]);
    }
    for (Index node = 0; node < graph_.nodes.size(); ++node) {
      if (!kept_[node] || representative_[node] == node) continue;
      auto& absorbed = result.nodes[number[representative_[node]]].absorbed;
      absorbed.insert(absorbed.end(), graph_.nodes[node].absorbed.begin(), graph_.nodes[node].absorbed.end());
    }
    for (const auto& [a, b] : edges_) {
      const auto [low, high] = std::minmax({number[representative_[a]], number[representative_[b]]});
      if (low != high) result.edges.push_back({low, high});
    }
    std::sort(result.edges.begin(), result.edges.end());
    result.edges.erase(std::unique(result.edges.begin(), result.edges.end()), result.edges.end());
    return result;
  }

  const AxisGraph& graph_;
  NodeSpacing spacing_;
  std::vector<std::vector<Index>> incident_;  ///< per node: edges
  std::vector<bool> used_;                    ///< per edge
  std::vector<bool> kept_;                    ///< per node
  std::vector<std::array<Index, 2>> edges_;   ///< of the decimated graph, in the old numbers
  std::vector<Index> representative_;         ///< per node: the node it was merged into
};

}  // namespace

AxisGraph decimate(const AxisGraph& graph, const NodeSpacing& spacing) { return Decimator(graph, spacing).decimate(); }

}  // namespace croquis::silhouette
