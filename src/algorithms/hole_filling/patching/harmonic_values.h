// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <Eigen/SparseCholesky>

#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// The new vertices of a patch with their neighbours: continues values from its rims so that each is the mean of its
/// neighbours'. Factored once, when first used.
class PatchGraph {
 public:
  /// @param vertices_given #V, see HolePatch
  PatchGraph(const HolePatch& patch, Index vertices_given);

  /// The vertices of the mesh that the patch uses, ascending.
  std::span<const Index> rim_vertices() const { return rim_; }

  /// @param known value per rim vertex @return value per new vertex
  std::vector<double> harmonic(std::span<const double> known) const;

 private:
  std::vector<Index> rim_;
  Eigen::SparseMatrix<double> to_rim_;  ///< #new by #rim, number of edges between
  std::unique_ptr<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>> laplacian_;
};

}  // namespace croquis::hole_filling
