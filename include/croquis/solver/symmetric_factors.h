// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace croquis {

/// Elimination by approximate minimum degree (Amestoy, Davis and Duff 1996) of a matrix that is symmetric already:
/// the library's own way adds the transposed pattern first, which takes as long as the ordering itself.
struct SymmetricOrdering {
  using PermutationType = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

  /// @param matrix both of its triangles
  template <typename Matrix>
  void operator()(const Matrix& matrix, PermutationType& order) const {
    Eigen::AMDOrdering<int>()(matrix.template selfadjointView<Eigen::Lower>(), order);
  }
};

/// L D L^T of a sparse symmetric matrix, of which the lower triangle is read.
using SymmetricFactors = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, SymmetricOrdering>;

}  // namespace croquis
