// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/faces/solid_graph.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>

#include <Eigen/Geometry>

namespace croquis {
namespace {

constexpr std::size_t spans_of_graph_curve = 16;

/// Numbers that differ by rounding alone get the same rank, × diagonal.
constexpr double same_rank = 1e-9;

Vec3 network_curve_at(const NetworkCurve& curve, double t) {
  const double scaled = t * static_cast<double>(curve.pieces.size());
  const std::size_t piece = std::min(static_cast<std::size_t>(scaled), curve.pieces.size() - 1);
  return curve.pieces[piece].at(scaled - static_cast<double>(piece));
}

std::vector<Vec3> graph_samples(const NetworkCurve& curve) {
  if (curve.straight) return {curve.pieces.front().points[0], curve.pieces.back().points[3]};
  std::vector<Vec3> samples;
  for (std::size_t i = 0; i <= spans_of_graph_curve; ++i) {
    samples.push_back(network_curve_at(curve, static_cast<double>(i) / static_cast<double>(spans_of_graph_curve)));
  }
  return samples;
}

using PlaceRank = std::array<Index, 3>;

/// For each point the ranks of its coordinates.
std::vector<PlaceRank> place_ranks(const std::vector<Vec3>& points, double size) {
  std::vector<PlaceRank> ranks(points.size());
  std::vector<Index> order(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, {}, [&](Index i) { return points[i][axis]; });
    Index rank = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i > 0 && points[order[i]][axis] - points[order[i - 1]][axis] > same_rank * size) ++rank;
      ranks[order[i]][static_cast<std::size_t>(axis)] = rank;
    }
  }
  return ranks;
}

/// Marks the edges that are in no cycle: dangling ones by stripping loose ends, then bridges by depth-first search.
class LooseEdges {
 public:
  LooseEdges(std::size_t vertices, const std::vector<GraphEdge>& edges)
      : edges_(edges), at_(vertices), removed_(edges.size(), 0), order_(vertices, 0), low_(vertices, 0) {
    for (Index e = 0; e < edges.size(); ++e) {
      at_[edges[e].start].push_back(e);
      at_[edges[e].end].push_back(e);
    }
  }

  std::vector<Index> strip_dangling() {
    std::vector<Index> found, pending(at_.size());
    std::iota(pending.begin(), pending.end(), Index{0});
    while (!pending.empty()) {
      const Index v = pending.back();
      pending.pop_back();
      if (std::ranges::count_if(at_[v], [&](Index e) { return removed_[e] == 0; }) != 1) continue;
      const Index e = *std::ranges::find_if(at_[v], [&](Index i) { return removed_[i] == 0; });
      removed_[e] = 1;
      found.push_back(e);
      pending.push_back(edges_[e].start == v ? edges_[e].end : edges_[e].start);
    }
    return found;
  }

  std::vector<Index> find_bridges() {
    for (Index v = 0; v < at_.size(); ++v) {
      if (order_[v] == 0) walk_from(v);
    }
    for (const Index e : bridges_) removed_[e] = 1;
    return bridges_;
  }

  bool removed(Index e) const { return removed_[e] != 0; }

 private:
  struct Step {
    Index vertex, by;
    std::size_t next = 0;
  };

  void walk_from(Index root) {
    std::vector<Step> path = {{root, no_index}};
    order_[root] = low_[root] = ++count_;
    while (!path.empty()) {
      Step& step = path.back();
      if (step.next < at_[step.vertex].size()) {
        const Index e = at_[step.vertex][step.next++];
        if (removed_[e] != 0 || e == step.by) continue;
        const Index other = edges_[e].start == step.vertex ? edges_[e].end : edges_[e].start;
        if (order_[other] != 0) {
          low_[step.vertex] = std::min(low_[step.vertex], order_[other]);
        } else {
          order_[other] = low_[other] = ++count_;
          path.push_back({other, e});
        }
        continue;
      }
      const Step done = step;
      path.pop_back();
      if (path.empty()) break;
      const Index above = path.back().vertex;
      low_[above] = std::min(low_[above], low_[done.vertex]);
      if (low_[done.vertex] > order_[above]) bridges_.push_back(done.by);
    }
  }

  const std::vector<GraphEdge>& edges_;
  std::vector<std::vector<Index>> at_;
  std::vector<std::uint8_t> removed_;
  std::vector<Index> order_, low_, bridges_;
  Index count_ = 0;
};

double diagonal_of(const std::vector<GraphEdge>& edges) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const GraphEdge& edge : edges) {
    for (const Vec3& p : edge.samples) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return edges.empty() ? 0 : (high - low).norm();
}

/// Renumbers vertices by place; vertex numbers of the edges change with them.
void sort_vertices(const CurveNetwork& network, SolidGraph& graph) {
  const std::vector<PlaceRank> ranks = place_ranks(network.vertices, graph.size);
  std::vector<Index> order(network.vertices.size()), number(network.vertices.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, {}, [&](Index v) { return ranks[v]; });
  for (Index i = 0; i < order.size(); ++i) {
    number[order[i]] = i;
    graph.points.push_back(network.vertices[order[i]]);
  }
  for (GraphEdge& edge : graph.edges) {
    edge.start = number[edge.start];
    edge.end = number[edge.end];
  }
}

void turn_graph_edge(GraphEdge& edge) {
  std::swap(edge.start, edge.end);
  edge.reversed = !edge.reversed;
  std::ranges::reverse(edge.samples);
}

void sort_edges(SolidGraph& graph) {
  std::vector<Vec3> early, late;
  for (GraphEdge& edge : graph.edges) {
    if (edge.start > edge.end) turn_graph_edge(edge);
    early.push_back(edge.samples[edge.samples.size() / 4]);
    late.push_back(edge.samples[edge.samples.size() - 1 - edge.samples.size() / 4]);
  }
  std::vector<Vec3> both = early;
  both.insert(both.end(), late.begin(), late.end());
  const std::vector<PlaceRank> ranks = place_ranks(both, graph.size);
  const std::size_t count = graph.edges.size();
  for (std::size_t e = 0; e < count; ++e) {  // closed curves
    if (graph.edges[e].start == graph.edges[e].end && ranks[count + e] < ranks[e]) turn_graph_edge(graph.edges[e]);
  }
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index{0});
  const auto key = [&](Index e) {
    const auto [low, high] = std::minmax(ranks[e], ranks[count + e]);
    const GraphEdge& edge = graph.edges[e];
    return std::tuple(edge.start, edge.end, edge.start == edge.end ? low : ranks[e],
                      edge.start == edge.end ? high : ranks[count + e]);
  };
  std::ranges::stable_sort(order, {}, key);
  std::vector<GraphEdge> sorted;
  for (const Index e : order) sorted.push_back(std::move(graph.edges[e]));
  graph.edges = std::move(sorted);
}

std::vector<Index> curves_of(const std::vector<GraphEdge>& edges, const std::vector<Index>& chosen) {
  std::vector<Index> curves;
  for (const Index e : chosen) curves.push_back(edges[e].curve);
  std::ranges::sort(curves);
  return curves;
}

}  // namespace

std::vector<Vec3> SolidGraph::polygon(const std::vector<Index>& loop, std::size_t step) const {
  std::vector<Vec3> outline;
  for (const Index half : loop) visit_samples(half, step, [&](const Vec3& p) { outline.push_back(p); });
  return outline;
}

std::vector<Index> SolidGraph::turned(const std::vector<Index>& loop) {
  std::vector<Index> result;
  for (auto half = loop.rbegin(); half != loop.rend(); ++half) result.push_back(twin(*half));
  return result;
}

SolidGraph make_solid_graph(const CurveNetwork& network) {
  SolidGraph graph;
  for (Index c = 0; c < network.curves.size(); ++c) {
    const NetworkCurve& curve = network.curves[c];
    graph.edges.push_back({c, false, curve.start, curve.end, curve.straight, graph_samples(curve)});
  }
  graph.size = diagonal_of(graph.edges);
  LooseEdges loose(network.vertices.size(), graph.edges);
  graph.dangling = curves_of(graph.edges, loose.strip_dangling());
  graph.bridges = curves_of(graph.edges, loose.find_bridges());
  std::vector<GraphEdge> kept;
  for (Index e = 0; e < graph.edges.size(); ++e) {
    if (!loose.removed(e)) kept.push_back(std::move(graph.edges[e]));
  }
  graph.edges = std::move(kept);
  sort_vertices(network, graph);
  sort_edges(graph);
  graph.outgoing.resize(graph.points.size());
  for (Index h = 0; h < 2 * graph.edges.size(); ++h) graph.outgoing[graph.origin(h)].push_back(h);
  return graph;
}

}  // namespace croquis
