// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

#include "implicit/cholesky.h"
#include "support/random.h"

namespace croquis::implicit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

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
