// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic_optimum.h"

#include <algorithm>

#include "solver/polishing.h"

namespace croquis {
namespace {

/// How much closer the interior point goes when the first polishing finds no roles that verify.
constexpr double second_effort = 1e-3;

/// Shortfall of rows that hold, in units of the largest violation: polishing leaves less.
constexpr double rounding_shortfall = 1e-9;
/// First price of the second attempt: where the first one ended.
constexpr double second_price = 1e6;
/// Steps of the second attempt leave room for those of the first (25 at most where rows can hold) and for polishing.
constexpr int second_steps = 25;
constexpr int most_factorisations = 40;
constexpr int polishing_reserve = 4;

bool falls_short(const ElasticPoint& point) { return point.shortfall.maxCoeff() > rounding_shortfall; }

ElasticPoint attempt(const ElasticProblem& problem, KktSystem& system, const LeastSquaresOptions& options,
                     ElasticPoint point, Progress& progress) {
  run_interior_point(problem, system, options, options.complementarity_tolerance, point, progress);
  if (point.converged && !polish(problem, system, point, progress)) {
    // Many rows that only just touch: their roles show a few steps later.
    run_interior_point(problem, system, options, second_effort * options.complementarity_tolerance, point, progress);
    if (point.converged) polish(problem, system, point, progress);
    point.converged = true;
  }
  return point;
}

}  // namespace

ElasticPoint find_elastic_optimum(const ElasticProblem& problem, KktSystem& system, const LeastSquaresOptions& options,
                                  bool contradictory, Progress& progress) {
  const int before = system.factorisations();
  ElasticPoint first = attempt(problem, system, options, starting_point(problem), progress);
  if (contradictory || !first.converged || !falls_short(first)) return first;

  LeastSquaresOptions bounded = options;
  const int left = most_factorisations - polishing_reserve - (system.factorisations() - before);
  bounded.max_iterations = std::min({options.max_iterations, second_steps, left});
  if (bounded.max_iterations <= 0) return first;
  ElasticPoint second = attempt(problem, system, bounded, starting_point(problem, second_price), progress);
  second.iterations += first.iterations;
  return second.converged && !falls_short(second) ? second : first;
}

}  // namespace croquis
