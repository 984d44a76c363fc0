// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "croquis/base/progress.h"

/// Sparse least squares with equalities and inequalities, solved to the optimum or with the rows named that can't hold.
namespace croquis {

/// Minimise 1/2 |U x - t|^2 subject to E x = e and G x >= h.
///
/// Any part may be missing: a matrix without rows (also a default-made one) and its empty vector stand for "none".
/// Unknowns and rows may have mixed units: the solver scales each of them by itself. Entries given twice are summed.
struct LeastSquaresProblem {
  Eigen::SparseMatrix<double> objective;     ///< U, #R by N
  Eigen::VectorXd target;                    ///< t, #R (empty: zero)
  Eigen::SparseMatrix<double> equalities;    ///< E, #E by N; dependent rows are welcome
  Eigen::VectorXd equality_values;           ///< e, #E (empty: zero)
  Eigen::SparseMatrix<double> inequalities;  ///< G, #I by N; 2..6 entries per row keep the factors sparse
  Eigen::VectorXd inequality_bounds;         ///< h, #I (empty: zero)
};

/// Every tolerance is relative, so the same problem in other units takes the same steps to the same answer.
struct LeastSquaresOptions {
  /// Interior-point steps. Rows that can hold together take up to 25, tens of contradictory ones up to 50.
  int max_iterations = 60;
  /// Interior point: |G y + s - w - b| at the end, where the largest violation of the start counts as 1.
  double primal_tolerance = 1e-8;
  /// Interior point: mean product of a row's distance and its multiplier, in the same scale.
  double complementarity_tolerance = 1e-9;
  /// A row holds while its shortfall is below this part of |h_q| + sum |G_qj x_j|; the same for equalities.
  double row_tolerance = 1e-7;
};

struct LeastSquaresSolution {
  Eigen::VectorXd x;  ///< N

  /// #I, max(0, h - G x). Zero up to rounding wherever the rows can hold together; else the sum of the shortfalls (in
  /// the rows' own units) is the least possible, and x the best among those.
  Eigen::VectorXd shortfall;
  Eigen::VectorXd multipliers;           ///< #I, >= 0: U^T (U x - t) = G^T multipliers + E^T equality_multipliers
  Eigen::VectorXd equality_multipliers;  ///< #E; one choice of them where equalities depend on each other

  std::vector<int> violated_rows;             ///< inequalities whose shortfall exceeds row_tolerance, ascending
  std::vector<int> contradictory_equalities;  ///< equalities whose residual exceeds row_tolerance, ascending

  /// Rounds of the active-set method, or interior-point steps where that one gave up; 0 when no inequality was violated
  /// at the equalities' optimum.
  int iterations = 0;
  int factorisations = 0;      ///< numeric ones, done by this call
  double primal_residual = 0;  ///< largest |E x - e| and shortfall of rows that hold, relative as row_tolerance
  double dual_residual = 0;    ///< largest entry of the stationarity residual, relative to the sum of its terms' sizes
  bool converged = true;       ///< false: max_iterations was reached, x is the last point

  /// #N: how far x would still move, were what is left of the stationarity's residual taken out of it while all rows
  /// let go. Shows what the residuals can't: where the objective holds a direction softly, a tiny one is a long way.
  Eigen::VectorXd remaining_step;

  /// The objective doesn't determine x: some direction that the equalities allow costs nothing. The answer is then the
  /// one near the smallest x, and small inputs' changes may move it far.
  bool singular_objective = false;
};

/// Solves the problem by a dual active-set method (Goldfarb and Idnani 1983) over the few rows that press, with one
/// sparse L D L^T factorisation, which the equalities' optimum needs anyway: rows that nothing comes near cost nothing.
///
/// Where rows contradict each other or hundreds of them press, a primal-dual interior point method with predictor and
/// corrector takes over (Mehrotra 1992; Nocedal and Wright 2006, section 16.6), with about 10 to 20 factorisations. It
/// works on the elastic form: every inequality may fall short at a price per unit that exceeds ten times the largest
/// multiplier, which makes the penalty exact (Nocedal and Wright 2006, section 17.2). The price ends at 1e6 times an
/// unknown's own curvature, or at 1e10 times where that leaves a shortfall that no contradiction explains: rows that
/// only a stronger force could hold count as contradictory.
///
/// Deterministic, single-threaded. Contradictory rows are no error: they are named in the result.
///
/// @throws Error (E_SOLVER) when sizes don't match or a number isn't finite, with one finding per part
/// @throws Cancelled when the progress was cancelled (asked before every factorisation)
LeastSquaresSolution solve_least_squares(const LeastSquaresProblem& problem, const LeastSquaresOptions& options,
                                         Progress& progress);

}  // namespace croquis
