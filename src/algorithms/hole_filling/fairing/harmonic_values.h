// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

  /// By conjugate gradients: about the square root of n rounds over n vertices.
  /// @param known value per rim vertex @param accuracy of how much they vary @return value per new vertex
  std::vector<double> harmonic(std::span<const double> known, double accuracy) const;
  std::vector<Vec3> harmonic(std::span<const Vec3> known, double accuracy) const;

 private:
  template <typename Value>
  std::vector<Value> solve(std::span<const Value> known, double accuracy) const;
  template <typename Value>
  void apply(const std::vector<Value>& values, std::vector<Value>& result) const;

  std::vector<Index> rim_;
  // Neighbours of new vertex v, once for each triangle at the edge: from first_[v] to first_[v + 1]. New vertices by
  // their number, those of the rim behind them.
  std::vector<Index> first_, neighbours_;
};

}  // namespace croquis::hole_filling
