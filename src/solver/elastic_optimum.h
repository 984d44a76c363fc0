// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/progress.h"
#include "croquis/solver/least_squares.h"
#include "solver/interior_point.h"
#include "solver/kkt_system.h"

namespace croquis {

/// The optimum of the elastic problem by the interior point, polished where the rows' roles show clearly.
///
/// @param system K(D) with the inequalities in its pattern
/// @throws Cancelled
ElasticPoint find_elastic_optimum(const ElasticProblem& problem, KktSystem& system, const LeastSquaresOptions& options,
                                  Progress& progress);

}  // namespace croquis
