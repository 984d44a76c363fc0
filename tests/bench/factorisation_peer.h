// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/solver/least_squares.h"

namespace croquis::bench {

/// Processor time in milliseconds of one numeric factorisation of a solver step's matrix by Eigen's SimplicialLDLT with
/// AMD ordering, pattern analysed before: what the solver's own steps are measured against.
double factorisation_ms(const LeastSquaresProblem& problem);

}  // namespace croquis::bench
