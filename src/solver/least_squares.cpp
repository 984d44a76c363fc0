// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/solver/least_squares.h"

#include "croquis/solver/least_squares_solver.h"

namespace croquis {

LeastSquaresSolution solve_least_squares(const LeastSquaresProblem& problem, const LeastSquaresOptions& options,
                                         Progress& progress) {
  return LeastSquaresSolver(problem, options).solve(progress);
}

}  // namespace croquis
