// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/layer_count.h"

#include <limits>

#include "croquis/base/error.h"

namespace croquis::silhouette {
namespace {

constexpr int unknown = std::numeric_limits<int>::min();

/// Layers on the triangle's side of its edge opposite to the corner, less those on the other side.
int step_across(const PlanarTriangulation& planar, std::span<const SidedSegment> segments, Index triangle,
                std::size_t corner) {
  const Index constraint = planar.constraints[triangle][corner];
  if (constraint == no_index) return 0;
  const SidedSegment& segment = segments[constraint];
  const bool same_sense = planar.triangles[triangle][(corner + 1) % 3] == segment.begin;
  return same_sense ? segment.side : -segment.side;
}

void enter(Index triangle, int count, std::vector<int>& layers, std::vector<Index>& queue) {
  if (layers[triangle] == unknown) {
    layers[triangle] = count;
    queue.push_back(triangle);
  }
  if (layers[triangle] != count || count < 0) {
    throw Error(make_error(Category::Internal, "E_INTERNAL", "The sides of the contours contradict each other"));
  }
}

}  // namespace

std::vector<int> count_layers(const PlanarTriangulation& planar, std::span<const SidedSegment> segments) {
  std::vector<int> layers(planar.triangles.size(), unknown);
  std::vector<Index> queue;
  for (Index t = 0; t < planar.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (planar.neighbours[t][corner] == no_index) {
        enter(t, step_across(planar, segments, t, corner), layers, queue);
      }
    }
  }
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const Index t = queue[head];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index next = planar.neighbours[t][corner];
      if (next != no_index) enter(next, layers[t] - step_across(planar, segments, t, corner), layers, queue);
    }
  }
  return layers;
}

}  // namespace croquis::silhouette
