// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "croquis/implicit/kernels.h"
#include "implicit/log.h"
#include "support/random.h"

namespace croquis::implicit {
namespace {

constexpr std::array all_kernels = {Kernel::Hermite, Kernel::Triharmonic, Kernel::Biharmonic, Kernel::ThinPlate,
                                    Kernel::HermiteQuintic};

Vec3 random_offset(test::Random& random, double reach) {
  return {random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach)};
}

TEST_CASE("values of the kernels at known radii") {
  const Vec3 two(0, 2, 0);
  CHECK(kernel_value(Kernel::Hermite, two) == 8);
  CHECK(kernel_value(Kernel::Triharmonic, two) == 8);
  CHECK(kernel_value(Kernel::HermiteQuintic, two) == 32);
  CHECK(kernel_value(Kernel::Biharmonic, two) == 2);
  CHECK(kernel_value(Kernel::ThinPlate, two) == Approx(4 * std::log(2.0)).epsilon(1e-15));
  for (const Kernel kernel : all_kernels) {
    CHECK(kernel_value(kernel, Vec3::Zero()) == 0);
  }
}

TEST_CASE("every kernel is definite, with its sign, where polynomials of its order are annulled") {
  test::Random random(2);
  for (const Kernel kernel : all_kernels) {
    const KernelTraits known = traits(kernel);
    const int count = 20;
    std::vector<Vec3> centres(count);
    for (Vec3& centre : centres) centre = random_offset(random, 1);
    Eigen::MatrixXd phi(count, count);
    Eigen::MatrixXd sides(count, known.order == 1 ? 1 : known.order == 2 ? 4 : 10);
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j)
        phi(i, j) = known.sign *
                    kernel_value(kernel, centres[static_cast<std::size_t>(i)] - centres[static_cast<std::size_t>(j)]);
      sides(i, 0) = 1;
      const Vec3& p = centres[static_cast<std::size_t>(i)];
      if (known.order > 1) sides.block<1, 3>(i, 1) = p.transpose();
      if (known.order > 2)
        sides.row(i).tail(6) << p.x() * p.x(), p.y() * p.y(), p.z() * p.z(), p.x() * p.y(), p.y() * p.z(),
            p.z() * p.x();
    }
    const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(sides).householderQ();
    const Eigen::MatrixXd null_space = q.rightCols(count - sides.cols());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(null_space.transpose() * phi * null_space);
    CHECK(eigen.eigenvalues().minCoeff() > 1e-6);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> whole(phi);
    CHECK(whole.eigenvalues().minCoeff() < 0);
  }
}

TEST_CASE("the portable logarithm is right to two units in the last place") {
  test::Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const double x = i % 2 == 0 ? random.between(0.5, 2) : std::exp(random.between(-80, 80));
    const double expected = std::log(x);
    CHECK(std::abs(log_of_normal(x) - expected) <= 4.5e-16 * std::abs(expected));
  }
  CHECK(log_of_normal(1) == 0);
}

}  // namespace
}  // namespace croquis::implicit
