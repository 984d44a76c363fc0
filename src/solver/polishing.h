// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/progress.h"
#include "solver/interior_point.h"
#include "solver/kkt_system.h"

namespace croquis {

/// Replaces a converged point by the exact optimum of the rows that it shows as active, when that verifies.
///
/// An interior point ends at a distance of the optimum, the square root of its tolerance where a row just touches;
/// the rows' roles are clear by then. With active rows as equations and short rows at their full price the optimum is
/// linear: one factorisation (a few when a role turns out wrong), refined by the method of multipliers.
///
/// @return false, and the point untouched, when no choice of roles verifies
bool polish(const ElasticProblem& problem, KktSystem& system, ElasticPoint& point, const Progress& progress);

}  // namespace croquis
