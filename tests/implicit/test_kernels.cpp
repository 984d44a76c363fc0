// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include "croquis/implicit/box_weight.h"
#include "croquis/implicit/kernels.h"
#include "implicit/lanes.h"
#include "implicit/sample_points.h"
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

const Box unit_box = {Vec3::Zero(), Vec3::Ones()};

/// (7a) and (7b) as they are printed, for points inside.
double printed_weight(const Box& box, const Vec3& point) {
  double product = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = box.high[axis] - box.low[axis];
    product *= 4 * (point[axis] - box.low[axis]) * (box.high[axis] - point[axis]) / (size * size);
  }
  const double d = 1 - product;
  return 1 - 10 * std::pow(d, 3) + 15 * std::pow(d, 4) - 6 * std::pow(d, 5);
}

TEST_CASE("weights of a unit box have their known values") {
  CHECK(box_weight(unit_box, Vec3(.5, .5, .5)).value == 1);
  CHECK(box_weight(unit_box, Vec3(.25, .5, .5)).value == Approx(.896484375).epsilon(1e-15));
  CHECK(box_weight(unit_box, Vec3(.25, .25, .25)).value ==
        Approx(printed_weight(unit_box, Vec3(.25, .25, .25))).epsilon(1e-14));
}

TEST_CASE("outside its box a weight is zero, where the formula alone would not be") {
  CHECK(printed_weight(unit_box, Vec3(-.1, -.1, .5)) > 0);
  const BoxWeight weight = box_weight(unit_box, Vec3(-.1, -.1, .5));
  CHECK(weight.value == 0);
  CHECK(weight.gradient == Vec3::Zero());
  CHECK(box_weight(unit_box, Vec3(1, .5, .5)).value == 0);
}

TEST_CASE("two boxes that overlap by a tenth share the middle of their face equally") {
  const Box left = Box{Vec3(0, 0, 0), Vec3(1, 1, 1)}.grown(0.1);
  const Box right = Box{Vec3(1, 0, 0), Vec3(2, 1, 1)}.grown(0.1);
  const Vec3 middle(1, .5, .5);
  CHECK(box_weight(left, middle).value == Approx(.0396).epsilon(5e-3));
  CHECK(box_weight(right, middle).value == Approx(box_weight(left, middle).value).epsilon(1e-12));
}

TEST_CASE("weights are twice continuously differentiable through the faces, with the gradient given") {
  const Box box = {Vec3(-.7, -.5, -.6), Vec3(.6, .8, .5)};
  for (const Vec3& p : test::random_points(500, 21)) {
    const BoxWeight weight = box_weight(box, p);
    CHECK((weight.value >= 0 && weight.value <= 1));
    CHECK(std::abs(weight.value - (box.contains(p) ? printed_weight(box, p) : 0)) < 1e-14);
    for (int axis = 0; axis < 3; ++axis) {
      const double step = 1e-5;
      const Vec3 aside = step * Vec3::Unit(axis);
      const double slope = (box_weight(box, p + aside).value - box_weight(box, p - aside).value) / (2 * step);
      CHECK(std::abs(slope - weight.gradient[axis]) < 1e-7);
    }
  }
  for (const double t : {-.6, -.2, .3}) {  // second derivatives just inside the face x = high are near 0
    const Vec3 face(.6, t, t / 2);
    const double near = 1e-4;
    const double second = (box_weight(box, face - Vec3(2 * near, 0, 0)).value -
                           2 * box_weight(box, face - Vec3(near, 0, 0)).value + box_weight(box, face).value) /
                          (near * near);
    CHECK(std::abs(second) < 0.3);
  }
}

}  // namespace
}  // namespace croquis::implicit
