// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace croquis {

/// |bound_q| + sum over j of |A_qj x_j|: the scale that a row's residual is judged by, whatever its unit.
template <typename Matrix>
Eigen::VectorXd row_sizes(const Matrix& matrix, const Eigen::VectorXd& x, const Eigen::VectorXd& bounds) {
  return bounds.cwiseAbs() + matrix.cwiseAbs() * x.cwiseAbs();
}

}  // namespace croquis
