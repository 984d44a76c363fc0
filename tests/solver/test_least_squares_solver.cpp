// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/solver/least_squares_solver.h"
#include "solver/sample_problems.h"

using namespace croquis;
using namespace croquis::test;

namespace {

void check_same(const LeastSquaresSolution& kept, const LeastSquaresProblem& problem) {
  Progress progress;
  const LeastSquaresSolution fresh = solve_least_squares(problem, {}, progress);
  CHECK(kept.x == fresh.x);
  CHECK(kept.multipliers == fresh.multipliers);
  CHECK(kept.iterations == fresh.iterations);
}

}  // namespace

TEST_CASE("a kept solver answers like a new one, to the bit, while targets and bounds change") {
  LeastSquaresProblem problem = depth_problem(chain_of_rings(3, 32), 18);
  LeastSquaresSolver solver(problem);
  Progress progress;
  check_same(solver.solve(progress), problem);

  problem.inequality_bounds *= 0.7;
  solver.set_inequality_bounds(problem.inequality_bounds);
  check_same(solver.solve(progress), problem);

  problem.target.setConstant(0.01);
  solver.set_target(problem.target);
  check_same(solver.solve(progress), problem);
}

TEST_CASE("new targets without a violated row cost no factorisation") {
  LeastSquaresProblem problem = depth_problem(chain_of_rings(2, 24), 18);
  problem.inequality_bounds.setConstant(-1e3);
  LeastSquaresSolver solver(problem);
  Progress progress;
  CHECK(solver.solve(progress).factorisations == 1);
  solver.set_target(Eigen::VectorXd::Constant(problem.target.size(), 0.1));
  CHECK(solver.solve(progress).factorisations == 0);
}

TEST_CASE("replacements of the wrong size or without finite numbers are refused and leave the solver as it was") {
  const LeastSquaresProblem problem = depth_problem(chain_of_rings(2, 24), 18);
  LeastSquaresSolver solver(problem);
  CHECK_THROWS_AS(solver.set_target(Eigen::VectorXd::Zero(1)), Error);
  CHECK_THROWS_AS(solver.set_inequality_bounds(Eigen::VectorXd::Constant(problem.inequality_bounds.size(),
                                                                         std::numeric_limits<double>::quiet_NaN())),
                  Error);
  Progress progress;
  check_same(solver.solve(progress), problem);
}
