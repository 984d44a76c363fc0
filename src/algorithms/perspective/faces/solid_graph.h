// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/curve_network.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// A curve that can bound faces, turned so that its direction follows from its geometry.
struct GraphEdge {
  Index curve = no_index;
  bool reversed = false;   ///< against the network's curve
  Index start = no_index;  ///< vertices of the graph
  Index end = no_index;
  bool straight = false;
  std::vector<Vec3> samples;  ///< from start to end: 2 of straight ones, else 17
};

/// The curves of a network that can bound faces, numbered by their geometry alone. Half-edge 2e runs along edge e,
/// 2e+1 against it.
struct SolidGraph {
  std::vector<Vec3> points;  ///< of the vertices
  std::vector<GraphEdge> edges;
  std::vector<std::vector<Index>> outgoing;  ///< of each vertex: half-edges that start there, ascending
  std::vector<Index> dangling;               ///< curves of the network
  std::vector<Index> bridges;                ///< curves of the network
  double size = 0;                           ///< diagonal of the box of all curves

  static Index twin(Index half) { return half ^ 1U; }
  Index origin(Index half) const { return (half & 1U) != 0 ? edges[half / 2].end : edges[half / 2].start; }
  Index target(Index half) const { return origin(twin(half)); }

  /// A loop run the other way around.
  static std::vector<Index> turned(const std::vector<Index>& loop);

  /// Calls visit for the samples of a half-edge in order, but the last: every step-th of a curve.
  template <typename Visit>
  void visit_samples(Index half, std::size_t step, const Visit& visit) const {
    const std::vector<Vec3>& samples = edges[half / 2].samples;
    const std::size_t last = samples.size() - 1;
    for (std::size_t i = 0; i < last; i += samples.size() == 2 ? 1 : step) {
      visit((half & 1U) != 0 ? samples[last - i] : samples[i]);
    }
  }

  /// The polygon of a loop of half-edges.
  std::vector<Vec3> polygon(const std::vector<Index>& loop, std::size_t step = 1) const;
};

/// Numbers vertices and curves by their places, and leaves out curves that are in no cycle.
SolidGraph make_solid_graph(const CurveNetwork& network);

/// What might be a face.
struct FaceCandidate {
  std::vector<std::vector<Index>> loops;  ///< half-edges of the graph; the outer one first, counter-clockwise about the
                                          ///< normal, holes clockwise
  std::vector<Index> edges;               ///< of the graph, ascending, each once
  bool planar = true;
  Vec3 origin = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  double flatness = 0;   ///< greatest distance from the plane
  double deviation = 0;  ///< rms distance to the mean plane by the root of the area
  double cost = 0;
  Index plane = no_index;      ///< number of the plane it was found in
  std::vector<Index> regions;  ///< of that plane, ascending: what it covers of its arrangement
};

}  // namespace croquis
