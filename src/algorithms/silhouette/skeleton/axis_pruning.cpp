// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/axis_pruning.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace croquis::silhouette {
namespace {

/// How far beyond the half circle over an edge swallowed points may lie, relative to its radius: round ends whose
/// samples lie on the circle must pass in spite of rounding and slight noise.
constexpr double covered_reach = 1.02;

class Pruner {
 public:
  Pruner(const ImmersedTriangulation& immersed, std::span<const Vec2> points)
      : immersed_(immersed), points_(points), swallowed_(immersed.triangles.size()) {
    pruning_.exit.assign(immersed.triangles.size(), no_index);
    for (const std::array<Index, 3>& neighbours : immersed.neighbours) {
      std::uint8_t open = 0;
      for (unsigned i = 0; i < 3; ++i) open = static_cast<std::uint8_t>(open | (neighbours[i] != no_index) << i);
      pruning_.open_edges.push_back(open);
    }
  }

  AxisPruning prune() {
    std::vector<Index> leaves;
    for (Index t = 0; t < immersed_.triangles.size(); ++t) {
      if (pruning_.open_count(t) == 1) leaves.push_back(t);
    }
    while (!leaves.empty()) {
      const Index leaf = leaves.back();
      leaves.pop_back();
      // Its last open edge may have closed meanwhile: then it is what remains of a blob.
      if (pruning_.open_count(leaf) != 1) continue;
      const Index neighbour = absorb(leaf);
      if (neighbour != no_index && pruning_.open_count(neighbour) == 1) leaves.push_back(neighbour);
    }
    return std::move(pruning_);
  }

 private:
  /// The neighbour that took a leaf in, or no_index if it stays.
  Index absorb(Index leaf) {
    const auto exit = static_cast<Index>(std::countr_zero(pruning_.open_edges[leaf]));
    std::vector<Index>& swallowed = swallowed_[leaf];
    swallowed.push_back(immersed_.triangles[leaf][exit]);
    if (!within_reach(leaf, exit)) {
      swallowed.pop_back();
      return no_index;
    }
    const Index neighbour = immersed_.neighbours[leaf][exit];
    const std::array<Index, 3>& back = immersed_.neighbours[neighbour];
    const auto entry = static_cast<unsigned>(std::find(back.begin(), back.end(), leaf) - back.begin());
    pruning_.exit[leaf] = exit;
    pruning_.open_edges[leaf] = 0;
    pruning_.open_edges[neighbour] = static_cast<std::uint8_t>(pruning_.open_edges[neighbour] & ~(1U << entry));
    std::vector<Index>& total = swallowed_[neighbour];
    if (total.size() < swallowed.size()) total.swap(swallowed);
    total.insert(total.end(), swallowed.begin(), swallowed.end());
    swallowed = {};
    return neighbour;
  }

  bool within_reach(Index leaf, Index exit) const {
    const std::array<Index, 3>& corners = immersed_.triangles[leaf];
    const Vec2& a = point(corners[(exit + 1) % 3]);
    const Vec2& b = point(corners[(exit + 2) % 3]);
    const Vec2 middle = (a + b) / 2;
    const double limit = covered_reach * covered_reach * (b - a).squaredNorm() / 4;
    return std::all_of(swallowed_[leaf].begin(), swallowed_[leaf].end(),
                       [&](Index vertex) { return (point(vertex) - middle).squaredNorm() <= limit; });
  }

  const Vec2& point(Index vertex) const { return points_[immersed_.planar_vertex[vertex]]; }

  const ImmersedTriangulation& immersed_;
  std::span<const Vec2> points_;
  AxisPruning pruning_;
  std::vector<std::vector<Index>> swallowed_;  ///< per triangle: contour points behind its closed inner edges
};

}  // namespace

int AxisPruning::open_count(Index triangle) const { return std::popcount(open_edges[triangle]); }

AxisPruning prune_axis(const ImmersedTriangulation& immersed, std::span<const Vec2> points) {
  return Pruner(immersed, points).prune();
}

}  // namespace croquis::silhouette
