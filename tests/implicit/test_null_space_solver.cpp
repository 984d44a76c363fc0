// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
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
  // Shortest: nothing of the direction that the columns don't determine.
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

MatrixXd positive_definite(Index n, test::Random& random) {
  MatrixXd m(n, n);
  for (Index i = 0; i < m.size(); ++i) m.data()[i] = random.between(-1, 1);
  return m * m.transpose() + 0.01 * MatrixXd::Identity(n, n);
}

TEST_CASE("factors and solutions of all sizes agree with a plain factorisation") {
  test::Random random(81);
  for (const Index n : {1, 2, 3, 4, 7, 8, 9, 47, 48, 49, 95, 97, 130, 259}) {
    const MatrixXd a = positive_definite(n, random);
    const Index stride = n + n % 3;  // also with a gap between the columns
    MatrixXd stored = MatrixXd::Constant(stride, n, 777);
    stored.topRows(n) = a;
    REQUIRE(factor_cholesky(stored.data(), static_cast<std::size_t>(n), static_cast<std::size_t>(stride), 0));
    const MatrixXd expected = a.llt().matrixL();
    const MatrixXd lower = stored.topRows(n).triangularView<Eigen::Lower>();
    INFO("size " << n);
    CHECK((lower - expected).norm() < 1e-10 * expected.norm());
    CHECK(MatrixXd(stored.topRows(n).triangularView<Eigen::StrictlyUpper>()) ==
          MatrixXd(a.triangularView<Eigen::StrictlyUpper>()));
    CHECK((stored.bottomRows(stride - n).array() == 777).all());
    Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, -1, 2);
    const Eigen::VectorXd b = a * x;
    Eigen::VectorXd solved = b;
    solve_cholesky(stored.data(), static_cast<std::size_t>(n), static_cast<std::size_t>(stride), solved.data());
    CHECK((a * solved - b).norm() < 1e-9 * b.norm());
  }
}

TEST_CASE("matrices that are not positive definite are noticed") {
  test::Random random(82);
  for (const Index n : {1, 5, 60, 100}) {
    MatrixXd a = positive_definite(n, random);
    a(n - 1, n - 1) = -1;
    CHECK_FALSE(factor_cholesky(a.data(), static_cast<std::size_t>(n), static_cast<std::size_t>(n), 0));
    MatrixXd nan = MatrixXd::Constant(n, n, NAN);
    CHECK_FALSE(factor_cholesky(nan.data(), static_cast<std::size_t>(n), static_cast<std::size_t>(n), 0));
  }
}

}  // namespace
}  // namespace croquis::implicit
