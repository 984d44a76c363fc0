// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/solver/least_squares.h"

namespace croquis {

/// The same problem with every matrix N columns wide, every vector as long as its matrix has rows, all compressed.
/// @throws Error (E_SOLVER), one finding per part whose size doesn't fit or that holds a number that isn't finite
LeastSquaresProblem checked_and_completed(LeastSquaresProblem problem);

/// Checks new numbers for an old place. @throws Error (E_SOLVER)
void check_replacement(const Eigen::VectorXd& vector, Eigen::Index size, const char* name);

}  // namespace croquis
