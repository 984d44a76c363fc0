// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "solver/row_flexibility.h"
#include "solver/sample_problems.h"

using namespace croquis;
using namespace croquis::test;
using Eigen::MatrixXd;

namespace {

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

}  // namespace

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
