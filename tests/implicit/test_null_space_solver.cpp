// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "implicit/null_space_solver.h"
#include "support/random.h"

namespace croquis::implicit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Index rows, Index columns, test::Random& random) {
  MatrixXd m(rows, columns);
  for (Index i = 0; i < m.size(); ++i) m.data()[i] = random.between(-1, 1);
  return m;
}

/// Positive definite where Q' x = 0, indefinite elsewhere, as the kernels' matrices are.
MatrixXd conditionally_definite(const MatrixXd& q, test::Random& random) {
  const MatrixXd m = random_matrix(q.rows(), q.rows(), random);
  return MatrixXd(m * m.transpose() + MatrixXd::Identity(q.rows(), q.rows()) - 50 * q * q.transpose());
}

TEST_CASE("weights and coefficients agree with a dense LU of the whole system") {
  test::Random random(91);
  for (const Index n : {5, 8, 20, 75, 160}) {
    for (const Index k : {1, 4}) {
      const MatrixXd q = random_matrix(n, k, random);
      const MatrixXd a = conditionally_definite(q, random);
      const VectorXd h = random_matrix(n, 1, random);
      MatrixXd spoilt = a;
      const ConstrainedWeights found = solve_constrained(spoilt, q, h);
      MatrixXd whole(n + k, n + k);
      whole << a, q, q.transpose(), MatrixXd::Zero(k, k);
      VectorXd right = VectorXd::Zero(n + k);
      right.head(n) = h;
      const VectorXd expected = whole.fullPivLu().solve(right);
      CHECK_FALSE(found.rank_revealing);
      CHECK(found.rank == k);
      CHECK((found.weights - expected.head(n)).norm() < 1e-8 * expected.norm());
      CHECK((found.coefficients - expected.tail(k)).norm() < 1e-8 * expected.norm());
    }
  }
}

TEST_CASE("as many conditions as unknowns leave no weights, and fewer centres than columns the shortest polynomial") {
  test::Random random(92);
  MatrixXd q = random_matrix(4, 4, random);
  MatrixXd a = MatrixXd::Zero(4, 4);
  const VectorXd h = random_matrix(4, 1, random);
  const ConstrainedWeights square = solve_constrained(a, q, h);
  CHECK(square.weights.norm() < 1e-14);
  CHECK((q * square.coefficients - h).norm() < 1e-12);
  MatrixXd flat = random_matrix(12, 4, random);
  flat.col(3) = flat.col(1) - 2 * flat.col(2);
  MatrixXd b = conditionally_definite(flat, random);
  const MatrixXd kept = b;
  const VectorXd values = random_matrix(12, 1, random);
  const ConstrainedWeights deficient = solve_constrained(b, flat, values);
  CHECK(deficient.rank == 3);
  CHECK((kept * deficient.weights + flat * deficient.coefficients - values).norm() < 1e-9);
  CHECK((flat.transpose() * deficient.weights).norm() < 1e-9);
  // Shortest: nothing of the direction that the columns can't tell.
  CHECK(std::abs(deficient.coefficients.dot(Eigen::Vector4d(0, -1, 2, 1))) < 1e-9);
}

TEST_CASE("a matrix that isn't definite there is solved by rank-revealing means, and says so") {
  test::Random random(93);
  const MatrixXd q = random_matrix(15, 4, random);
  MatrixXd a = random_matrix(15, 15, random);
  a = MatrixXd(a + a.transpose());
  const MatrixXd kept = a;
  const VectorXd h = random_matrix(15, 1, random);
  const ConstrainedWeights found = solve_constrained(a, q, h);
  CHECK(found.rank_revealing);
  CHECK((kept * found.weights + q * found.coefficients - h).norm() < 1e-9);
  CHECK((q.transpose() * found.weights).norm() < 1e-9);
}

}  // namespace
}  // namespace croquis::implicit
