// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/edge_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "croquis/geometry/mesh_tags.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::subdivision {
namespace {

/// The chain edges of a level around each vertex.
class ChainGraph {
 public:
  ChainGraph(const Level& level, double least_sharpness)
      : mesh_(level.topology), stops_(mesh_.vertex_count(), false), at_(mesh_.vertex_count(), {no_index, no_index}) {
    std::vector<std::uint8_t> count(mesh_.vertex_count(), 0);
    for (const SharpEdge& sharp : level.sharp) {
      if (sharp.sharpness < least_sharpness) continue;
      for (const Index v : ends(sharp.edge)) {
        if (count[v] < 2) at_[v][count[v]] = sharp.edge;
        count[v] = static_cast<std::uint8_t>(std::min(count[v] + 1, 3));
      }
    }
    for (std::size_t v = 0; v < stops_.size(); ++v) stops_[v] = count[v] > 2;
    for (const Index corner : level.boundary) stops_[mesh_.corner_vertex[corner]] = true;
    for (const Index pin : level.pins) stops_[pin] = true;
  }

  std::array<Index, 2> ends(Index edge) const {
    const Index corner = mesh_.edge_corner[edge];
    return {mesh_.corner_vertex[corner], mesh_.corner_vertex[mesh_.twin[corner]]};
  }

  Index other_end(Index edge, Index vertex) const {
    const auto [a, b] = ends(edge);
    return a == vertex ? b : a;
  }

  /// The edge that goes on at a vertex, or no_index where the chain ends there.
  Index following(Index edge, Index vertex) const {
    if (stops_[vertex]) return no_index;
    return at_[vertex][0] == edge ? at_[vertex][1] : at_[vertex][0];
  }

  ChainEnd end_at(Index vertex) const { return stops_[vertex] ? ChainEnd::Corner : ChainEnd::Dart; }

 private:
  const HalfEdges& mesh_;
  std::vector<bool> stops_;
  std::vector<std::array<Index, 2>> at_;
};

/// Edges and vertices from an edge onwards, away from a vertex.
void walk(const ChainGraph& graph, Index edge, Index from, EdgeChain& chain) {
  const Index first = edge;
  chain.vertices.push_back(from);
  do {
    chain.edges.push_back(edge);
    from = graph.other_end(edge, from);
    chain.vertices.push_back(from);
    edge = graph.following(edge, from);
  } while (edge != no_index && edge != first);
  chain.closed = edge == first;
  if (chain.closed) chain.vertices.pop_back();
}

void reverse(EdgeChain& chain) {
  std::reverse(chain.edges.begin(), chain.edges.end());
  std::reverse(chain.vertices.begin(), chain.vertices.end());
}

void orient_open(const ChainGraph& graph, EdgeChain& chain) {
  const auto key = [](Index vertex, Index edge) { return std::pair(vertex, edge); };
  if (key(chain.vertices.back(), chain.edges.back()) < key(chain.vertices.front(), chain.edges.front())) {
    reverse(chain);
  }
  chain.ends = {graph.end_at(chain.vertices.front()), graph.end_at(chain.vertices.back())};
}

void orient_closed(EdgeChain& chain) {
  const auto lowest = std::min_element(chain.vertices.begin(), chain.vertices.end()) - chain.vertices.begin();
  std::rotate(chain.vertices.begin(), chain.vertices.begin() + lowest, chain.vertices.end());
  std::rotate(chain.edges.begin(), chain.edges.begin() + lowest, chain.edges.end());
  const auto forward = std::pair(chain.vertices[1], chain.edges.front());
  if (std::pair(chain.vertices.back(), chain.edges.back()) < forward) {
    std::reverse(chain.vertices.begin() + 1, chain.vertices.end());
    std::reverse(chain.edges.begin(), chain.edges.end());
  }
}

EdgeChain chain_through(const ChainGraph& graph, Index edge) {
  const auto [a, b] = graph.ends(edge);
  EdgeChain ahead;
  walk(graph, edge, a, ahead);
  if (ahead.closed) {
    orient_closed(ahead);
    return ahead;
  }
  EdgeChain whole;
  walk(graph, ahead.edges.back(), ahead.vertices.back(), whole);
  orient_open(graph, whole);
  return whole;
}

/// The plane through the centre of the vertices in which they scatter most.
void fit_plane(const EdgeChain& chain, std::span<const Vec3> positions, ChainShape& shape) {
  constexpr double line_share = 1e-18;  // of variances: the square of the planar tolerance
  Vec3 centre = Vec3::Zero();
  for (const Index v : chain.vertices) centre += positions[v];
  centre /= static_cast<double>(chain.vertices.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Index v : chain.vertices) scatter += (positions[v] - centre) * (positions[v] - centre).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter);
  shape.plane_point = centre;
  shape.plane_normal = Vec3::Zero();
  if (axes.eigenvalues()[1] <= line_share * axes.eigenvalues()[2]) return;
  shape.plane_normal = axes.eigenvectors().col(0);
  for (const Index v : chain.vertices) {
    shape.deviation = std::max(shape.deviation, std::abs((positions[v] - centre).dot(shape.plane_normal)));
  }
}

/// Measures chains of one level.
class Surveyor {
 public:
  Surveyor(const Level& level, std::span<const Vec3> positions)
      : mesh_(level.topology), around_(mesh_), sharpness_(edge_sharpness(level)), positions_(positions) {}

  ChainShape measure(const EdgeChain& chain) const {
    ChainShape shape;
    fit_plane(chain, positions_, shape);
    shape.least_bend = 4;  // more than any angle
    for (const Index edge : chain.edges) {
      const Index corner = mesh_.edge_corner[edge];
      shape.length += (positions_[end_of(corner)] - positions_[mesh_.corner_vertex[corner]]).norm();
      const double bend = bend_at(corner);
      shape.least_bend = std::min(shape.least_bend, bend);
      shape.greatest_bend = std::max(shape.greatest_bend, bend);
    }
    const std::size_t count = chain.vertices.size();
    for (std::size_t i = chain.closed ? 0 : 1; i < (chain.closed ? count : count - 1); ++i) {
      measure_sides(chain.vertices[i], chain.edges[i], shape);
    }
    return shape;
  }

 private:
  Index end_of(Index corner) const { return mesh_.corner_vertex[around_.next(corner)]; }

  double bend_at(Index corner) const {
    return angle_between(area_normal(positions_, mesh_.face(around_.face(corner))),
                         area_normal(positions_, mesh_.face(around_.face(mesh_.twin[corner]))));
  }

  /// Turns once around a vertex within the chain: from the edge on which it goes on, first through its left side.
  void measure_sides(Index vertex, Index next_edge, ChainShape& shape) const {
    Index start = mesh_.vertex_corner[vertex];
    while (mesh_.corner_edge[start] != next_edge) start = mesh_.twin[around_.previous(start)];
    std::size_t side = 0;
    for (Index corner = mesh_.twin[around_.previous(start)]; corner != start;
         corner = mesh_.twin[around_.previous(corner)]) {
      if (sharpness_[mesh_.corner_edge[corner]] >= 1) {
        side = 1;
      } else {
        shape.side_bends[side] = std::max(shape.side_bends[side], bend_at(corner));
      }
    }
  }

  const HalfEdges& mesh_;
  CornerFaces around_;
  std::vector<double> sharpness_;
  std::span<const Vec3> positions_;
};

}  // namespace

std::vector<EdgeChain> edge_chains(const Level& level, double least_sharpness) {
  const ChainGraph graph(level, least_sharpness);
  std::vector<double> sharpness(level.topology.edge_count(), 0);
  for (const SharpEdge& sharp : level.sharp) sharpness[sharp.edge] = sharp.sharpness;
  std::vector<bool> done(level.topology.edge_count(), false);
  std::vector<EdgeChain> chains;
  for (const SharpEdge& sharp : level.sharp) {
    if (done[sharp.edge] || sharp.sharpness < least_sharpness) continue;
    EdgeChain& chain = chains.emplace_back(chain_through(graph, sharp.edge));
    chain.least_sharpness = infinite_sharpness;
    for (const Index edge : chain.edges) {
      done[edge] = true;
      chain.least_sharpness = std::min(chain.least_sharpness, sharpness[edge]);
      chain.greatest_sharpness = std::max(chain.greatest_sharpness, sharpness[edge]);
    }
  }
  return chains;
}

std::vector<ChainShape> chain_shapes(const Level& level, std::span<const EdgeChain> chains,
                                     std::span<const Vec3> positions) {
  const Surveyor surveyor(level, positions);
  std::vector<ChainShape> shapes;
  for (const EdgeChain& chain : chains) shapes.push_back(surveyor.measure(chain));
  return shapes;
}

}  // namespace croquis::subdivision
