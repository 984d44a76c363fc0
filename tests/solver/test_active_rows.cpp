// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include <catch2/catch.hpp>

#include "solver/active_rows.h"
#include "solver/elastic_optimum.h"
#include "solver/sample_problems.h"

using namespace croquis;
using namespace croquis::test;
using Eigen::VectorXd;

namespace {

/// The problem of the rows alone: what they ask for is measured from 0.
struct Rows {
  explicit Rows(const LeastSquaresProblem& problem) : scaled(scale(problem)) {
    elastic.matrices = &scaled;
    elastic.bounds = scaled.inequality_scale.cwiseProduct(problem.inequality_bounds);
    elastic.bounds /= elastic.bounds.maxCoeff();
    elastic.prices = VectorXd::Ones(elastic.bounds.size());
  }

  ScaledProblem scaled;
  ElasticProblem elastic;
};

double difference(const VectorXd& a, const VectorXd& b) { return (a - b).lpNorm<Eigen::Infinity>(); }

}  // namespace

TEST_CASE("the rows that press give the same optimum as the interior point") {
  for (const LeastSquaresProblem& problem :
       {depth_problem(chain_of_rings(5, 32), 18), depth_problem(chain_of_rings(2, 96), 18),
        depth_problem(trefoil(181), 36), sheet_problem(12, 2, 0.3), sheet_problem(24, 3, 0.5),
        sheet_problem(30, 2, 0.75), sheet_problem(40, 2, 0.02)}) {
    CAPTURE(problem.objective.cols(), problem.inequalities.rows());
    const Rows rows(problem);
    REQUIRE(rows.elastic.bounds.maxCoeff() == 1);
    Progress progress;
    KktSystem rest(rows.scaled, KktSystem::Rows::None);
    REQUIRE(rest.factorise({}));
    ElasticPoint active;
    REQUIRE(find_active_rows(rows.elastic, rest, active, progress) == DualActiveSet::Outcome::Solved);
    CHECK(rest.factorisations() == 1);

    KktSystem weighted(rows.scaled, KktSystem::Rows::Weighted);
    const ElasticPoint interior = find_elastic_optimum(rows.elastic, weighted, {}, false, progress);
    CHECK(interior.converged);
    CHECK(interior.iterations <= 25);
    CHECK(weighted.factorisations() <= 40);
    CHECK(difference(active.y, interior.y) <= 1e-8 * (1 + interior.y.lpNorm<Eigen::Infinity>()));
    CHECK(difference(active.multipliers, interior.multipliers) <= 1e-7 * interior.multipliers.maxCoeff());
    CHECK(active.penalty > active.multipliers.maxCoeff());
    CHECK(interior.shortfall.maxCoeff() <= 1e-9);
  }
}

TEST_CASE("random rows have the same optimum by the interior point alone") {
  int all_hold = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    RandomShape shape;
    shape.unknowns = 2 + static_cast<int>(seed % 9);
    shape.objective_rows = shape.unknowns + static_cast<int>(seed % 5);
    shape.equalities = std::min(static_cast<int>(seed % 4), shape.unknowns - 1);
    shape.inequalities = 3 + static_cast<int>(seed % 17);
    shape.tight = static_cast<int>(seed) % shape.inequalities;
    LeastSquaresProblem problem = random_problem(shape, seed);
    // Measured from 0, where the equalities hold: now some rows contradict each other.
    problem.inequality_bounds = problem.inequality_bounds.cwiseMin(1.0).cwiseAbs() * 0.1;
    problem.inequality_bounds[0] = 1;
    const Rows rows(problem);
    Progress progress;
    KktSystem rest(rows.scaled, KktSystem::Rows::None);
    REQUIRE(rest.factorise({}));
    KktSystem weighted(rows.scaled, KktSystem::Rows::Weighted);
    const ElasticPoint interior = find_elastic_optimum(rows.elastic, weighted, {}, false, progress);
    CHECK(interior.converged);
    ElasticPoint active;
    const bool held = find_active_rows(rows.elastic, rest, active, progress) == DualActiveSet::Outcome::Solved;
    CHECK(held == (interior.shortfall.maxCoeff() <= 1e-9));
    all_hold += held ? 1 : 0;
    if (held) CHECK(difference(active.y, interior.y) <= 1e-7 * (1 + interior.y.lpNorm<Eigen::Infinity>()));
  }
  CHECK(all_hold >= 50);
  CHECK(all_hold <= 190);
}

TEST_CASE("the interior point holds rows at a higher price when the first was too low") {
  // The equality couples x0, which has to be 1, to a lever 3000 times as long.
  LeastSquaresProblem problem;
  problem.objective = Eigen::MatrixXd::Identity(2, 2).sparseView();
  problem.equalities = Eigen::MatrixXd((Eigen::MatrixXd(1, 2) << 1, 1.0 / 3000).finished()).sparseView();
  problem.inequalities = Eigen::MatrixXd((Eigen::MatrixXd(1, 2) << 1, 0).finished()).sparseView();
  problem.inequality_bounds = VectorXd::Ones(1);
  const Rows rows(problem);
  Progress progress;
  KktSystem weighted(rows.scaled, KktSystem::Rows::Weighted);
  const ElasticPoint point = find_elastic_optimum(rows.elastic, weighted, {}, false, progress);
  CHECK(point.converged);
  CHECK(point.shortfall.maxCoeff() <= 1e-9);
  CHECK(point.y[1] == Approx(-3000));
  CHECK(point.multipliers[0] == Approx(1 + 9e6));
  CHECK(weighted.factorisations() <= 40);
  KktSystem known(rows.scaled, KktSystem::Rows::Weighted);
  CHECK(find_elastic_optimum(rows.elastic, known, {}, true, progress).shortfall[0] > 0.5);
}
