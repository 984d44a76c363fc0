// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "croquis/solver/least_squares.h"

namespace croquis::test {

/// The optimum by dense means that share nothing with the solver: null space of the equalities, then least distance
/// programming by non-negative least squares (Lawson and Hanson 1974, chapter 23). None when the rows contradict each
/// other. The objective must have full rank on the null space.
std::optional<Eigen::VectorXd> dense_optimum(const LeastSquaresProblem& problem);

}  // namespace croquis::test
