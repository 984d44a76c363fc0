// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "croquis/base/progress.h"
#include "croquis/solver/least_squares.h"
#include "solver/kkt_system.h"

namespace croquis {

/// Minimise 1/2 y^T H y + penalty * sum prices_q s_q subject to E y = 0, G y + s >= b, s >= 0.
///
/// y is the vector from the equalities' optimum to the optimum, in units of the largest violation found there: so the
/// largest entry of b is 1 and y = 0 satisfies the equalities.
struct ElasticProblem {
  const ScaledProblem* matrices = nullptr;
  Eigen::VectorXd bounds;  ///< b, #I
  Eigen::VectorXd prices;  ///< #I, > 0: what a unit of each scaled row's shortfall costs
};

/// A point of the elastic problem with its multipliers; w = G y + s - b. All of w, s, lambda, mu are >= 0.
struct ElasticPoint {
  Eigen::VectorXd y;                  ///< N
  Eigen::VectorXd equality;           ///< nu, #E: H y = G^T lambda + E^T nu
  Eigen::VectorXd distance;           ///< w, #I
  Eigen::VectorXd shortfall;          ///< s, #I
  Eigen::VectorXd multipliers;        ///< lambda of G y + s >= b, #I
  Eigen::VectorXd slack_multipliers;  ///< mu of s >= 0, #I: lambda + mu = penalty * prices
  double penalty = 0;                 ///< per unit of shortfall
  int penalty_raises = 0;
  int iterations = 0;
  bool converged = false;
};

/// First penalty per unit of shortfall, where an unknown's own curvature and the largest violation are 1. It is raised
/// up to 1e4 times.
inline constexpr double first_penalty = 1e2;

/// Where the method starts: y = 0, every row at a distance, shortfalls small.
ElasticPoint starting_point(const ElasticProblem& problem, double penalty = first_penalty);

/// Mehrotra's predictor-corrector method from `point` until the mean product of the pairs (w, lambda) and (s, mu) is at
/// most `complementarity`; s is eliminated, so a step factorises K(D) with D = 1 / (w/lambda + s/mu).
void run_interior_point(const ElasticProblem& problem, KktSystem& system, const LeastSquaresOptions& options,
                        double complementarity, ElasticPoint& point, Progress& progress);

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
