// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// The new vertices of a patch with their neighbours: continues values from its rims so that each is the mean of its
/// neighbours'.
class PatchGraph {
 public:
  /// @param vertices_given #V, see HolePatch. Linear
  PatchGraph(const HolePatch& patch, Index vertices_given);

  /// The vertices of the mesh that the patch uses, ascending.
  std::span<const Index> rim_vertices() const { return rim_; }

  /// By conjugate gradients: about the fourth root of n rounds over n vertices, times the logarithm of 1 / accuracy.
  /// @param known value per rim vertex @param accuracy of how much they vary @return value per new vertex
  std::vector<double> harmonic(std::span<const double> known, double accuracy) const;
  std::vector<Vec3> harmonic(std::span<const Vec3> known, double accuracy) const;

 private:
  template <typename Value>
  class Relaxations;

  /// Where the parts of a vertex' neighbours begin, and where they end: those before it, behind it, and of the rim.
  struct List {
    Index begin = 0, behind = 0, rim = 0, end = 0;
  };

  std::span<const Index> part(Index begin, Index end) const {
    return {neighbours_.data() + begin, neighbours_.data() + end};
  }
  std::span<const Index> before(Index i) const { return part(lists_[i].begin, lists_[i].behind); }
  std::span<const Index> behind(Index i) const { return part(lists_[i].behind, lists_[i].rim); }
  std::span<const Index> on_rim(Index i) const { return part(lists_[i].rim, lists_[i].end); }
  std::size_t valence(Index i) const { return lists_[i].end - lists_[i].begin; }

  void link(std::span<const std::array<Index, 3>> triangles, std::size_t count);
  template <typename Value>
  std::vector<Value> solve(std::span<const Value> known, double accuracy) const;

  std::vector<Index> rim_;
  std::vector<Index> order_;  ///< of the new vertices; here they are called by their places in it
  std::vector<List> lists_;
  std::vector<Index> neighbours_;  ///< ascending for each vertex; those of the rim are counted on behind the new ones
};

}  // namespace croquis::hole_filling
