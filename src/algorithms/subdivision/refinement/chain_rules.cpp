// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/chain_rules.h"

namespace croquis::subdivision {

void append_scaled(WeightRow& row, const WeightRow& other, double factor) {
  for (const auto& [vertex, weight] : other) row.push_back({vertex, factor * weight});
}

bool ChainRules::pinned_dart(Index vertex) const {
  return near_.classes.class_of[vertex] == VertexClass::Dart &&
         (near_.classes.pinned[vertex] != 0 || rules_.chain_ends == ChainEnds::Pin);
}

/// Whether the chain's point is the old vertex itself: at pinned ends, and where the edge runs into a kept vertex
/// without a band.
bool ChainRules::stays(Index line, std::size_t end) const {
  const Index vertex = near_.classes.lines[line].vertices[end];
  return pinned_dart(vertex) || near_.points.chain(line, end) == near_.points.kept(vertex);
}

/// The middle between the plain points of the two faces beside the chain's end: it runs out into the surface.
WeightRow ChainRules::smooth_dart(Index line, std::size_t end) const {
  const SharpLine& sharp = near_.classes.lines[line];
  WeightRow row;
  for (std::size_t side = 0; side < 2; ++side) {
    const Index half_edge = sharp.half_edges[side];
    Index corner = side == end ? half_edge : near_.around.next(half_edge);
    const std::size_t n = near_.level.topology.face(near_.around.face(corner)).size();
    for (const double weight : mask_.row(n)) {
      row.push_back({near_.level.topology.corner_vertex[corner], 0.5 * weight});
      corner = near_.around.next(corner);
    }
  }
  return row;
}

WeightRow ChainRules::chain_point(Index line, std::size_t end) const {
  const SharpLine& sharp = near_.classes.lines[line];
  const Index here = sharp.vertices[end], there = sharp.vertices[1 - end];
  if (stays(line, end)) return {{here, 1}};
  if (near_.classes.class_of[here] == VertexClass::Dart && rules_.chain_ends == ChainEnds::Smooth) {
    return smooth_dart(line, end);
  }
  // Beside a point that stays, a clamped B-spline has a knot interval of half the length.
  if (rules_.profile == Profile::Clamped && stays(line, 1 - end)) return {{here, 0.5}, {there, 0.5}};
  return {{here, 0.75}, {there, 0.25}};
}

}  // namespace croquis::subdivision
