// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "solver/dual_active_set.h"
#include "support/sample_count.h"

using croquis::DualActiveSet;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

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
