// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/axis_graph.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/predicates.h"

namespace croquis::silhouette {
namespace {

/// How far beyond the half circle over an edge swallowed points may lie, relative to its radius: round ends whose
/// samples lie on the circle must pass in spite of rounding and slight noise.
constexpr double covered_reach = 1.02;

class AxisBuilder {
 public:
  AxisBuilder(const ImmersedTriangulation& immersed, std::span<const Vec2> points, double reach)
      : immersed_(immersed),
        points_(points),
        reach_(reach),
        open_(immersed.triangles.size()),
        exit_(immersed.triangles.size(), no_index),
        edge_node_(3 * immersed.triangles.size(), no_index),
        cap_radius_(immersed.triangles.size(), std::numeric_limits<double>::quiet_NaN()),
        cap_node_(immersed.triangles.size(), no_index) {
    for (Index t = 0; t < open_.size(); ++t) {
      for (Index i = 0; i < 3; ++i) open_[t][i] = immersed.neighbours[t][i] != no_index;
    }
  }

  /// Absorbs insignificant branches (Igarashi, Matsuoka, Tanaka 1999, section 5.1, extended past junctions): a triangle
  /// with one open edge goes if all contour points swallowed so far lie within reach times the half length of that edge
  /// from its midpoint; then its neighbour is next. What is left doesn't depend on the order, except that of a blob
  /// that is absorbed altogether an arbitrary triangle, without open edges, remains.
  void prune_axis() {
    std::vector<std::vector<Index>> swallowed(open_.size());  // contour points behind closed inner edges
    std::vector<Index> leaves;
    for (Index t = 0; t < open_.size(); ++t) {
      if (open_[t].count() == 1) leaves.push_back(t);
    }
    while (!leaves.empty()) {
      const Index leaf = leaves.back();
      leaves.pop_back();
      // Its last open edge may have closed meanwhile: then it is what remains of a blob.
      if (open_[leaf].count() != 1) continue;
      const Index exit = open_corner(leaf);
      std::vector<Index>& own = swallowed[leaf];
      own.push_back(immersed_.triangles[leaf][exit]);
      if (!covers(leaf, exit, own)) continue;
      const Index neighbour = immersed_.neighbours[leaf][exit];
      exit_[leaf] = exit;
      absorbed_.push_back(leaf);
      open_[leaf].reset();
      open_[neighbour].reset(corner_across(immersed_.neighbours, neighbour, leaf));
      std::vector<Index>& total = swallowed[neighbour];
      if (total.size() < own.size()) total.swap(own);
      total.insert(total.end(), own.begin(), own.end());
      own = {};
      if (open_[neighbour].count() == 1) leaves.push_back(neighbour);
    }
  }

  std::vector<std::bitset<3>> take_open() { return std::move(open_); }

  AxisGraph build() {
    for (Index t = 0; t < open_.size(); ++t) {
      if (exit_[t] != no_index) continue;
      switch (open_[t].count()) {
        case 0: add_blob(t); break;
        case 1: add_end(t); break;
        case 2: add_sleeve(t); break;
        default: add_junction(t);
      }
    }
    spread_caps();
    measure_contours();
    return std::move(graph_);
  }

 private:
  const Vec2& point(Index vertex) const { return points_[immersed_.planar_vertex[vertex]]; }

  std::array<Vec2, 3> corners(Index t) const {
    const auto& [a, b, c] = immersed_.triangles[t];
    return {point(a), point(b), point(c)};
  }

  std::array<Index, 2> edge_ends(Index t, Index corner) const {
    return {immersed_.triangles[t][next(corner)], immersed_.triangles[t][previous(corner)]};
  }

  /// Of the only open edge.
  Index open_corner(Index t) const { return open_[t][0] ? 0 : open_[t][1] ? 1 : 2; }

  bool covers(Index t, Index corner, const std::vector<Index>& vertices) const {
    const auto [a, b] = edge_ends(t, corner);
    const Vec2 middle = (point(a) + point(b)) / 2;
    const double limit = reach_ * reach_ * (point(b) - point(a)).squaredNorm() / 4;
    return std::all_of(vertices.begin(), vertices.end(),
                       [&](Index vertex) { return (point(vertex) - middle).squaredNorm() <= limit; });
  }

  AxisNode edge_middle(Index t, Index corner) const {
    const auto [a, b] = edge_ends(t, corner);
    return {(point(a) + point(b)) / 2, (point(b) - point(a)).norm() / 2, t, corner};
  }

  AxisNode longest_edge_middle(Index t) const {
    AxisNode longest = edge_middle(t, 0);
    for (const Index i : {1U, 2U}) {
      const AxisNode other = edge_middle(t, i);
      if (other.radius > longest.radius) longest = other;
    }
    return longest;
  }

  /// The middle of the circle through a triangle's corners, if it lies inside the triangle.
  std::optional<AxisNode> inner_circumcentre(Index t) const {
    const std::array<Vec2, 3> triangle = corners(t);
    const Vec2 u = triangle[1] - triangle[0];
    const Vec2 v = triangle[2] - triangle[0];
    const Vec2 offset = (v.squaredNorm() * left_of(u) - u.squaredNorm() * left_of(v)) / (2 * cross(u, v));
    const Vec2 centre = triangle[0] + offset;
    for (Index i = 0; i < 3; ++i) {
      if (orientation(triangle[i], triangle[next(i)], centre) <= 0) return std::nullopt;
    }
    return AxisNode{centre, offset.norm(), t, no_index};
  }

  AxisNode centroid(Index t) const {
    const std::array<Vec2, 3> triangle = corners(t);
    AxisNode node{(triangle[0] + triangle[1] + triangle[2]) / 3, std::numeric_limits<double>::infinity(), t, no_index};
    for (const Vec2& corner : triangle) node.radius = std::min(node.radius, (corner - node.position).norm());
    return node;
  }

  Index add_node(const AxisNode& node) {
    graph_.nodes.push_back(node);
    return static_cast<Index>(graph_.nodes.size() - 1);
  }

  /// The node in the middle of an inner edge, the same from both of its sides.
  Index middle(Index t, Index corner) {
    Index& node = edge_node_[3 * t + corner];
    if (node == no_index) {
      node = add_node(edge_middle(t, corner));
      const Index twin = immersed_.neighbours[t][corner];
      if (twin != no_index) edge_node_[3 * twin + corner_across(immersed_.neighbours, twin, t)] = node;
    }
    return node;
  }

  void add_sleeve(Index t) {
    std::array<Index, 2> joined{};
    std::size_t count = 0;
    for (Index i = 0; i < 3; ++i) {
      if (open_[t][i]) joined[count++] = middle(t, i);
    }
    graph_.edges.push_back(joined);
    cap_radius_[t] = (graph_.nodes[joined[0]].radius + graph_.nodes[joined[1]].radius) / 2;
  }

  void add_junction(Index t) {
    const std::optional<AxisNode> centre = inner_circumcentre(t);
    const Index node = add_node(centre ? *centre : centroid(t));
    for (Index i = 0; i < 3; ++i) graph_.edges.push_back({node, middle(t, i)});
  }

  /// A terminal triangle, or one whose other branches were absorbed while it couldn't be: a branch ends here.
  void add_end(Index t) {
    const Index open = open_corner(t);
    const Index way_on = middle(t, open);
    std::vector<Index> absorbed;
    for (Index i = 0; i < 3; ++i) {
      if (i != open && immersed_.neighbours[t][i] != no_index) absorbed.push_back(i);
    }
    Index end = way_on;
    if (absorbed.size() == 1) {
      end = middle(t, absorbed.front());
    } else if (absorbed.size() == 2) {
      const std::optional<AxisNode> centre = inner_circumcentre(t);
      end = centre ? add_node(*centre) : middle(t, longest_edge_middle(t).corner);
    }
    if (end != way_on) graph_.edges.push_back({end, way_on});
    cap_radius_[t] = graph_.nodes[end].radius;
    cap_node_[t] = end;
  }

  /// The whole component was absorbed: its largest circle stands for it, so that the node doesn't depend on the order.
  void add_blob(Index root) {
    std::vector<Index> triangles{root};
    std::vector<bool> seen(open_.size(), false);
    seen[root] = true;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (const Index twin : immersed_.neighbours[triangles[i]]) {
        if (twin == no_index || seen[twin]) continue;
        seen[twin] = true;
        triangles.push_back(twin);
      }
    }
    std::sort(triangles.begin(), triangles.end());
    AxisNode best;
    const auto offer = [&](const AxisNode& node) {
      if (node.radius > best.radius) best = node;
    };
    for (const Index t : triangles) {
      if (const std::optional<AxisNode> centre = inner_circumcentre(t)) offer(*centre);
    }
    const bool has_circle = best.triangle != no_index;
    for (std::size_t i = 0; i < triangles.size() && !has_circle; ++i) offer(longest_edge_middle(triangles[i]));
    cap_node_[root] = add_node(best);
    cap_radius_[root] = best.radius;
  }

  /// Gives absorbed triangles the radius, and the node, of the cap or blob that they became part of. A bulge at the
  /// side of a sleeve has no node of its own.
  void spread_caps() {
    for (auto t = absorbed_.rbegin(); t != absorbed_.rend(); ++t) {
      const Index absorbing = immersed_.neighbours[*t][exit_[*t]];
      cap_radius_[*t] = cap_radius_[absorbing];
      cap_node_[*t] = cap_node_[absorbing];
    }
    for (Index t = 0; t < open_.size(); ++t) {
      if (exit_[t] == no_index || cap_node_[t] == no_index) continue;
      graph_.nodes[cap_node_[t]].absorbed.push_back(edge_ends(t, exit_[t]));
    }
  }

  void measure_contours() {
    const std::size_t count = immersed_.planar_vertex.size();
    graph_.vertex_radius.assign(count, std::numeric_limits<double>::quiet_NaN());
    for (Index t = 0; t < open_.size(); ++t) {
      for (Index i = 0; i < 3; ++i) {
        double& result = graph_.vertex_radius[immersed_.triangles[t][i]];
        // An absorbed triangle swallowed the corner opposite to its exit.
        if (std::isnan(result) || i == exit_[t]) result = cap_radius_[t];
      }
    }
    std::vector<double> sum(count, 0);
    std::vector<int> chords(count, 0);
    for (const AxisNode& node : graph_.nodes) {
      if (node.corner == no_index) continue;
      for (const Index vertex : edge_ends(node.triangle, node.corner)) {
        sum[vertex] += node.radius;
        ++chords[vertex];
      }
    }
    for (std::size_t v = 0; v < count; ++v) {
      if (chords[v] > 0) graph_.vertex_radius[v] = sum[v] / chords[v];
    }
  }

  const ImmersedTriangulation& immersed_;
  std::span<const Vec2> points_;
  double reach_;
  std::vector<std::bitset<3>> open_;  ///< per triangle: edges, by the corners opposite, that lead on along the axis
  std::vector<Index> exit_;           ///< per triangle: the corner opposite to the edge it was absorbed through
  std::vector<Index> absorbed_;       ///< triangles, in that order
  std::vector<Index> edge_node_;      ///< per triangle and corner
  std::vector<double> cap_radius_;    ///< per triangle
  std::vector<Index> cap_node_;       ///< per triangle: the node of the cap or blob that it belongs to
  AxisGraph graph_;
};

}  // namespace

AxisGraph axis_graph(const ImmersedTriangulation& immersed, std::span<const Vec2> points) {
  AxisBuilder builder(immersed, points, covered_reach);
  builder.prune_axis();
  return builder.build();
}

std::vector<std::bitset<3>> open_edges(const ImmersedTriangulation& immersed, std::span<const Vec2> points,
                                       double reach) {
  AxisBuilder builder(immersed, points, reach);
  builder.prune_axis();
  return builder.take_open();
}

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
