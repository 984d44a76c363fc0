// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/progress.h"
#include "croquis/solver/least_squares.h"
#include "solver/interior_point.h"
#include "solver/kkt_system.h"

namespace croquis {

/// The optimum of the elastic problem by the interior point, polished where the rows' roles show clearly.
///
/// Rows that fall short at the highest price get a second attempt at a price 1e4 times as high, since the force that
/// holds them may be a strong one: at most 40 factorisations altogether.
///
/// @param system K(D) with the inequalities in its pattern
/// @param contradictory the rows are known to contradict each other: no second attempt
/// @throws Cancelled
ElasticPoint find_elastic_optimum(const ElasticProblem& problem, KktSystem& system, const LeastSquaresOptions& options,
                                  bool contradictory, Progress& progress);

}  // namespace croquis
