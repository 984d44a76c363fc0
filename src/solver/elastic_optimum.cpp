// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic_optimum.h"

#include "solver/polishing.h"

namespace croquis {
namespace {

/// How much closer the interior point goes when the first polishing finds no roles that verify.
constexpr double second_effort = 1e-3;

}  // namespace

ElasticPoint find_elastic_optimum(const ElasticProblem& problem, KktSystem& system, const LeastSquaresOptions& options,
                                  Progress& progress) {
  ElasticPoint point = starting_point(problem);
  run_interior_point(problem, system, options, options.complementarity_tolerance, point, progress);
  if (point.converged && !polish(problem, system, point, progress)) {
    // Many rows that only just touch: their roles show a few steps later.
    run_interior_point(problem, system, options, second_effort * options.complementarity_tolerance, point, progress);
    if (point.converged) polish(problem, system, point, progress);
    point.converged = true;
  }
  return point;
}

}  // namespace croquis
