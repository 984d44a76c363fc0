// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "croquis/base/progress.h"
#include "croquis/solver/least_squares.h"

namespace croquis {

/// Solves one problem again and again while its targets and bounds change, as while a point is dragged.
///
/// What depends on its matrices alone (ordering, symbolic factorisation, the factorisation of the equalities' optimum)
/// is kept for the solver's life. The answers are the same, to the bit, as those of solve_least_squares on the same
/// problem.
class LeastSquaresSolver {
 public:
  /// @throws Error (E_SOLVER) as solve_least_squares
  explicit LeastSquaresSolver(LeastSquaresProblem problem, LeastSquaresOptions options = {});
  ~LeastSquaresSolver();
  LeastSquaresSolver(LeastSquaresSolver&&) noexcept;
  LeastSquaresSolver& operator=(LeastSquaresSolver&&) noexcept;

  /// New numbers in the old places. @throws Error (E_SOLVER) when the size differs or a number isn't finite
  void set_target(Eigen::VectorXd target);                        ///< #R
  void set_inequality_bounds(Eigen::VectorXd inequality_bounds);  ///< #I

  /// @throws Cancelled; the solver stays usable
  LeastSquaresSolution solve(Progress& progress);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace croquis
