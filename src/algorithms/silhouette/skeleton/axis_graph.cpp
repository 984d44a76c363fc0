// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/axis_graph.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "croquis/geometry/predicates.h"

namespace croquis::silhouette {
namespace {

struct Circle {
  Vec2 centre = Vec2::Zero();
  double radius = 0;
};

/// The circle through three points, if its centre lies inside their triangle.
std::optional<Circle> inner_circumcircle(const std::array<Vec2, 3>& corners) {
  const Vec2 u = corners[1] - corners[0];
  const Vec2 v = corners[2] - corners[0];
  const Vec2 offset = (v.squaredNorm() * left_of(u) - u.squaredNorm() * left_of(v)) / (2 * cross(u, v));
  const Vec2 centre = corners[0] + offset;
  for (std::size_t i = 0; i < 3; ++i) {
    if (orientation(corners[i], corners[(i + 1) % 3], centre) <= 0) return std::nullopt;
  }
  return Circle{centre, offset.norm()};
}

class GraphBuilder {
 public:
  GraphBuilder(const ImmersedTriangulation& immersed, std::span<const Vec2> points, const AxisPruning& pruning)
      : immersed_(immersed),
        points_(points),
        pruning_(pruning),
        edge_node_(3 * immersed.triangles.size(), no_index),
        cap_radius_(immersed.triangles.size(), std::numeric_limits<double>::quiet_NaN()),
        cap_node_(immersed.triangles.size(), no_index) {}

  AxisGraph build() {
    for (Index t = 0; t < immersed_.triangles.size(); ++t) {
      if (pruning_.exit[t] != no_index) continue;
      switch (pruning_.open_count(t)) {
        case 0: add_blob(t); break;
        case 1: add_end(t); break;
        case 2: add_sleeve(t); break;
        default: add_junction(t);
      }
    }
    measure_contours();
    collect_absorbed_chords();
    return std::move(graph_);
  }

 private:
  const Vec2& point(Index vertex) const { return points_[immersed_.planar_vertex[vertex]]; }

  std::array<Vec2, 3> corners(Index t) const {
    const auto& [a, b, c] = immersed_.triangles[t];
    return {point(a), point(b), point(c)};
  }

  std::array<Index, 2> edge_ends(Index t, Index corner) const {
    return {immersed_.triangles[t][(corner + 1) % 3], immersed_.triangles[t][(corner + 2) % 3]};
  }

  double edge_radius(Index t, Index corner) const {
    const auto [a, b] = edge_ends(t, corner);
    return (point(b) - point(a)).norm() / 2;
  }

  Index longest_edge(Index t) const {
    Index longest = 0;
    for (const Index i : {1U, 2U}) longest = edge_radius(t, i) > edge_radius(t, longest) ? i : longest;
    return longest;
  }

  Index twin_corner(Index t, Index corner) const {
    const std::array<Index, 3>& back = immersed_.neighbours[immersed_.neighbours[t][corner]];
    return static_cast<Index>(std::find(back.begin(), back.end(), t) - back.begin());
  }

  Index add_node(const AxisNode& node) {
    graph_.nodes.push_back(node);
    return static_cast<Index>(graph_.nodes.size() - 1);
  }

  /// The node in the middle of an inner edge, the same from both of its sides.
  Index middle(Index t, Index corner) {
    Index& node = edge_node_[3 * t + corner];
    if (node == no_index) {
      const auto [a, b] = edge_ends(t, corner);
      node = add_node({(point(a) + point(b)) / 2, edge_radius(t, corner), t, corner, {}});
      const Index twin = immersed_.neighbours[t][corner];
      if (twin != no_index) edge_node_[3 * twin + twin_corner(t, corner)] = node;
    }
    return node;
  }

  void add_sleeve(Index t) {
    std::array<Index, 2> joined{};
    std::size_t count = 0;
    for (Index i = 0; i < 3; ++i) {
      if (pruning_.is_open(t, i)) joined[count++] = middle(t, i);
    }
    graph_.edges.push_back(joined);
    cap_radius_[t] = (graph_.nodes[joined[0]].radius + graph_.nodes[joined[1]].radius) / 2;
  }

  void add_junction(Index t) {
    AxisNode centre{Vec2::Zero(), 0, t, no_index, {}};
    const std::array<Vec2, 3> triangle = corners(t);
    if (const auto circle = inner_circumcircle(triangle)) {
      centre.position = circle->centre;
      centre.radius = circle->radius;
    } else {
      centre.position = (triangle[0] + triangle[1] + triangle[2]) / 3;
      centre.radius = std::numeric_limits<double>::infinity();
      for (const Vec2& corner : triangle) {
        centre.radius = std::min(centre.radius, (corner - centre.position).norm());
      }
    }
    const Index node = add_node(centre);
    for (Index i = 0; i < 3; ++i) graph_.edges.push_back({node, middle(t, i)});
  }

  /// A terminal triangle, or one whose other branches were absorbed while it couldn't be: a branch ends here.
  void add_end(Index t) {
    const auto open = static_cast<Index>(std::countr_zero(pruning_.open_edges[t]));
    const Index way_on = middle(t, open);
    cap_radius_[t] = graph_.nodes[way_on].radius;
    cap_node_[t] = way_on;
    std::vector<Index> absorbed;
    for (Index i = 0; i < 3; ++i) {
      if (i != open && immersed_.neighbours[t][i] != no_index) absorbed.push_back(i);
    }
    if (absorbed.empty()) return;
    Index end = no_index;
    if (absorbed.size() == 1) {
      end = middle(t, absorbed.front());
    } else if (const auto circle = inner_circumcircle(corners(t))) {
      end = add_node({circle->centre, circle->radius, t, no_index, {}});
    } else if (const Index longest = longest_edge(t); longest != open) {
      end = middle(t, longest);
    }
    if (end == no_index) return;
    graph_.edges.push_back({end, way_on});
    cap_radius_[t] = graph_.nodes[end].radius;
    cap_node_[t] = end;
  }

  /// The whole component was absorbed: its largest circle stands for it, so that the node doesn't depend on the order.
  void add_blob(Index root) {
    std::vector<Index> triangles{root};
    std::vector<bool> seen(immersed_.triangles.size(), false);
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
    for (const Index t : triangles) {
      const auto circle = inner_circumcircle(corners(t));
      if (circle && circle->radius > best.radius) best = {circle->centre, circle->radius, t, no_index, {}};
    }
    if (best.triangle == no_index) best = longest_chord(triangles);
    cap_node_[root] = add_node(best);
    cap_radius_[root] = best.radius;
  }

  AxisNode longest_chord(const std::vector<Index>& triangles) const {
    AxisNode best;
    for (const Index t : triangles) {
      const Index corner = longest_edge(t);
      const auto [a, b] = edge_ends(t, corner);
      if (edge_radius(t, corner) <= best.radius) continue;
      best = {(point(a) + point(b)) / 2, edge_radius(t, corner), t, corner, {}};
    }
    return best;
  }

  /// The radius of the cap or bulge that a triangle became part of.
  double absorbed_radius(Index t) {
    std::vector<Index> chain;
    while (std::isnan(cap_radius_[t]) && pruning_.exit[t] != no_index) {
      chain.push_back(t);
      t = immersed_.neighbours[t][pruning_.exit[t]];
    }
    for (const Index member : chain) {
      cap_radius_[member] = cap_radius_[t];
      cap_node_[member] = cap_node_[t];
    }
    return cap_radius_[t];
  }

  void measure_contours() {
    const std::size_t count = immersed_.planar_vertex.size();
    std::vector<double> sum(count, 0);
    std::vector<int> chords(count, 0);
    for (const AxisNode& node : graph_.nodes) {
      if (node.corner == no_index) continue;
      for (const Index vertex : edge_ends(node.triangle, node.corner)) {
        sum[vertex] += node.radius;
        ++chords[vertex];
      }
    }
    graph_.vertex_radius.assign(count, std::numeric_limits<double>::quiet_NaN());
    for (Index t = 0; t < immersed_.triangles.size(); ++t) {
      const double radius = absorbed_radius(t);
      for (const Index vertex : immersed_.triangles[t]) {
        double& result = graph_.vertex_radius[vertex];
        if (std::isnan(result) || belongs_to(t, vertex)) result = radius;
      }
    }
    for (std::size_t v = 0; v < count; ++v) {
      if (chords[v] > 0) graph_.vertex_radius[v] = sum[v] / chords[v];
    }
  }

  /// Caps and blobs; a bulge at the side of a sleeve has no node of its own.
  void collect_absorbed_chords() {
    for (Index t = 0; t < immersed_.triangles.size(); ++t) {
      if (pruning_.exit[t] == no_index || cap_node_[t] == no_index) continue;
      graph_.nodes[cap_node_[t]].absorbed.push_back(edge_ends(t, pruning_.exit[t]));
    }
  }

  /// An absorbed triangle swallowed the corner opposite to its exit.
  bool belongs_to(Index t, Index vertex) const {
    return pruning_.exit[t] != no_index && immersed_.triangles[t][pruning_.exit[t]] == vertex;
  }

  const ImmersedTriangulation& immersed_;
  std::span<const Vec2> points_;
  const AxisPruning& pruning_;
  std::vector<Index> edge_node_;    ///< per triangle and corner
  std::vector<double> cap_radius_;  ///< per triangle
  std::vector<Index> cap_node_;     ///< per triangle: the node of the cap or blob that it belongs to
  AxisGraph graph_;
};

}  // namespace

AxisGraph axis_graph(const ImmersedTriangulation& immersed, std::span<const Vec2> points, const AxisPruning& pruning) {
  return GraphBuilder(immersed, points, pruning).build();
}

}  // namespace croquis::silhouette
