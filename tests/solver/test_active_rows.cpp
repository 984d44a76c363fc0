// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "solver/active_rows.h"
#include "solver/elastic_optimum.h"
#include "solver/sample_problems.h"
#include "support/sample_count.h"

using namespace croquis;
using namespace croquis::test;
using croquis::DualActiveSet;
using Eigen::MatrixXd;
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

/// S of all rows by dense elimination of the regularised matrix.
MatrixXd dense_flexibility(const ScaledProblem& problem) {
  const Eigen::Index unknowns = problem.objective.cols();
  const Eigen::Index equalities = problem.equalities.rows();
  MatrixXd matrix = MatrixXd::Zero(unknowns + equalities, unknowns + equalities);
  const MatrixXd objective = problem.objective;
  const MatrixXd held = problem.equalities;
  matrix.topLeftCorner(unknowns, unknowns) = objective.transpose() * objective;
  matrix.bottomLeftCorner(equalities, unknowns) = held;
  matrix.topRightCorner(unknowns, equalities) = held.transpose();
  matrix.diagonal().head(unknowns).array() += KktSystem::regularisation;
  matrix.diagonal().tail(equalities).array() -= KktSystem::equality_regularisation;
  MatrixXd rows = MatrixXd::Zero(problem.inequalities.rows(), matrix.cols());
  rows.leftCols(unknowns) = MatrixXd(problem.inequalities);
  return rows * matrix.partialPivLu().solve(rows.transpose());
}

constexpr double tolerance = 1e-12;

MatrixXd random_rows(std::mt19937& random, int rows, int columns) {
  MatrixXd matrix(rows, columns);
  for (double& value : matrix.reshaped()) value = static_cast<double>(random()) / 2147483648.0 - 1;
  return matrix;
}

void add_rows(const MatrixXd& flexibility, Eigen::Index begin, Eigen::Index end, DualActiveSet& set) {
  for (Eigen::Index row = begin; row < end; ++row) set.add_row(flexibility.col(row).head(row + 1));
}

/// The conditions of min 1/2 l^T S l - b^T l over l >= 0, which hold at its optimum alone.
void check_optimal(const MatrixXd& flexibility, const VectorXd& bounds, const VectorXd& multipliers) {
  const VectorXd violation = bounds - flexibility * multipliers;
  CHECK(multipliers.minCoeff() >= 0);
  CHECK(violation.maxCoeff() <= 1e-9);
  CHECK(std::abs(multipliers.dot(violation)) <= 1e-9 * (1 + multipliers.sum()));
}

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

TEST_CASE("the flexibility of rows is that of dense elimination") {
  RandomShape shape;
  shape.unknowns = 9;
  shape.objective_rows = 12;
  shape.equalities = 3;
  shape.inequalities = 7;
  for (const LeastSquaresProblem& problem :
       {depth_problem(chain_of_rings(2, 24), 22), sheet_problem(8, 2, 0.5), random_problem(shape, 4)}) {
    const ScaledProblem scaled = scale(problem);
    KktSystem system(scaled, KktSystem::Rows::None);
    REQUIRE(system.factorise({}));
    const MatrixXd expected = dense_flexibility(scaled);
    RowFlexibility flexibility(scaled, system);
    const Eigen::Index rows = problem.inequalities.rows();
    REQUIRE(rows > 3);
    // From the last row to the first: the order is the caller's.
    for (Eigen::Index asked = 0; asked < rows; ++asked) {
      const Eigen::VectorXd column = flexibility.add(rows - 1 - asked);
      REQUIRE(column.size() == asked + 1);
      for (Eigen::Index other = 0; other <= asked; ++other)
        CHECK(column[other] == Approx(expected(rows - 1 - asked, rows - 1 - other)).margin(1e-7 * expected.maxCoeff()));
    }
  }
}

TEST_CASE("multipliers of random rows meet the optimality conditions, given at once or in parts") {
  std::mt19937 random(3);
  for (int trial = 0; trial < croquis::test::sample_count(200, 5000); ++trial) {
    CAPTURE(trial);
    const int rows = 1 + static_cast<int>(random() % 24u);
    const int unknowns = 1 + static_cast<int>(random() % 30u);
    const MatrixXd g = random_rows(random, rows, unknowns);
    const MatrixXd flexibility = g * g.transpose();
    // Some point meets all of them, so that they don't contradict each other.
    const VectorXd bounds = g * random_rows(random, unknowns, 1) - 0.3 * random_rows(random, rows, 1).cwiseAbs();

    DualActiveSet whole;
    add_rows(flexibility, 0, rows, whole);
    VectorXd violation = bounds;
    REQUIRE(whole.solve(violation, tolerance) == DualActiveSet::Outcome::Solved);
    check_optimal(flexibility, bounds, whole.multipliers());

    DualActiveSet parts;
    const Eigen::Index half = rows / 2;
    add_rows(flexibility, 0, half, parts);
    VectorXd first = bounds.head(half);
    REQUIRE(parts.solve(first, tolerance) == DualActiveSet::Outcome::Solved);
    add_rows(flexibility, half, rows, parts);
    VectorXd second = bounds - flexibility.leftCols(half) * parts.multipliers().head(half);
    REQUIRE(parts.solve(second, tolerance) == DualActiveSet::Outcome::Solved);
    check_optimal(flexibility, bounds, parts.multipliers());
  }
}

TEST_CASE("bounds that change a little are followed from the last active set") {
  std::mt19937 random(5);
  const MatrixXd g = random_rows(random, 12, 15);
  const MatrixXd flexibility = g * g.transpose();
  VectorXd bounds = random_rows(random, 12, 1);
  DualActiveSet set;
  add_rows(flexibility, 0, 12, set);
  VectorXd violation = bounds;
  REQUIRE(set.solve(violation, tolerance) == DualActiveSet::Outcome::Solved);
  for (int change = 0; change < 30; ++change) {
    CAPTURE(change);
    bounds += 0.3 * random_rows(random, 12, 1);
    violation = bounds - flexibility * set.multipliers();
    REQUIRE(set.solve(violation, tolerance) == DualActiveSet::Outcome::Solved);
    check_optimal(flexibility, bounds, set.multipliers());
  }
}

TEST_CASE("rows that contradict each other are refused, repeated ones are not") {
  MatrixXd opposite(2, 2);
  opposite << 1, -1, -1, 1;
  DualActiveSet contradictory;
  add_rows(opposite, 0, 2, contradictory);
  VectorXd violation = VectorXd::Constant(2, 0.5);
  CHECK(contradictory.solve(violation, tolerance) == DualActiveSet::Outcome::Contradictory);

  DualActiveSet repeated;
  add_rows(MatrixXd::Ones(3, 3), 0, 3, repeated);
  violation = (VectorXd(3) << 0.25, 1, 0.5).finished();
  CHECK(repeated.solve(violation, tolerance) == DualActiveSet::Outcome::Solved);
  CHECK(repeated.multipliers() == VectorXd((VectorXd(3) << 0, 1, 0).finished()));
}
