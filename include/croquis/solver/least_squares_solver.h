// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "croquis/base/progress.h"
#include "croquis/solver/least_squares.h"

namespace croquis {

/// Solves one problem again and again while its numbers change, as when a weight or a point is dragged.
///
/// What depends on the pattern alone (ordering, symbolic factorisation) is kept for the solver's life; the
/// factorisation of the equalities' optimum is kept until the objective changes. The answers are the same, to the bit,
/// as those of solve_least_squares on the same problem.
class LeastSquaresSolver {
 public:
  /// @throws Error (E_SOLVER) as solve_least_squares
  explicit LeastSquaresSolver(LeastSquaresProblem problem, LeastSquaresOptions options = {});
  ~LeastSquaresSolver();
  LeastSquaresSolver(LeastSquaresSolver&&) noexcept;
  LeastSquaresSolver& operator=(LeastSquaresSolver&&) noexcept;

  /// New numbers in the old places. @throws Error (E_SOLVER) when the size differs or a number isn't finite
  void set_target(Eigen::VectorXd target);                        ///< #R
  void set_equality_values(Eigen::VectorXd equality_values);      ///< #E
  void set_inequality_bounds(Eigen::VectorXd inequality_bounds);  ///< #I
  void set_objective(Eigen::SparseMatrix<double> objective);      ///< #R by N; any pattern, the same one is quicker

  /// @throws Cancelled; the solver stays usable
  LeastSquaresSolution solve(Progress& progress);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace croquis
