// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "croquis/solver/least_squares.h"

namespace croquis {

using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The problem's matrices free of units: x = column_scale * y, and each row of E and G divided by its length.
///
/// Lengths and gradients side by side, and drawings in any unit, so give the same numbers up to rounding.
struct ScaledProblem {
  Eigen::SparseMatrix<double> objective;  ///< #R by N, columns of length 1 (or empty)
  RowMatrix equalities;                   ///< #E by N, rows of length 1 (or empty)
  RowMatrix inequalities;                 ///< #I by N, rows of length 1 (or empty)
  Eigen::VectorXd column_scale;           ///< N, > 0
  Eigen::VectorXd equality_scale;         ///< #E, > 0: scaled row = factor * row
  Eigen::VectorXd inequality_scale;       ///< #I, > 0
};

/// @param problem checked and complete (see problem_check.h)
ScaledProblem scale(const LeastSquaresProblem& problem);

}  // namespace croquis
