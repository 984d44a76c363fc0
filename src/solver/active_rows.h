// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/progress.h"
#include "solver/dual_active_set.h"
#include "solver/interior_point.h"
#include "solver/kkt_system.h"

namespace croquis {

/// Looks for the optimum among those where every row holds, through the few rows that press there.
///
/// In rounds: the rows violated most join those known, their multipliers are found by a dual active-set method on the
/// known rows alone, and one solve with the factors of K(0) moves the unknowns and refines them. No factorisation, and
/// rows that nothing comes near cost nothing. Ends where the optimality conditions hold up to rounding.
///
/// @param system holds the factors of K(0)
/// @param point set to the optimum, its penalty large enough for its multipliers; untouched when there is none
/// @return Contradictory when no forces hold all rows, GaveUp when more of them press than this method is meant for
DualActiveSet::Outcome find_active_rows(const ElasticProblem& problem, const KktSystem& system, ElasticPoint& point,
                                        Progress& progress);

}  // namespace croquis
