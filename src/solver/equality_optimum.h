// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "solver/kkt_system.h"
#include "solver/scaled_problem.h"

namespace croquis {

/// The scaled least-squares optimum under the equalities alone.
struct EqualityOptimum {
  Eigen::VectorXd y;         ///< N
  Eigen::VectorXd equality;  ///< multipliers nu, #E: U^T (U y - t) = E^T nu
};

/// Solves with the factorisation of K(0) that `system` holds. Equalities that contradict each other are met in the
/// least-squares sense, so that each of them shows a residual.
EqualityOptimum find_equality_optimum(const ScaledProblem& problem, const KktSystem& system,
                                      const Eigen::VectorXd& target, const Eigen::VectorXd& equality_values);

/// True when the objective has no curvature in some direction that the equalities allow. Inverse iteration with the
/// factorisation of K(0): the regularisation is the smallest curvature then, and such a direction wins at once.
bool has_flat_direction(const ScaledProblem& problem, const KktSystem& system);

}  // namespace croquis
