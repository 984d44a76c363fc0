// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/implicit/box_weight.h"
#include "croquis/implicit/local_fit.h"
#include "implicit/sample_points.h"
#include "support/random.h"

namespace croquis::implicit {
namespace {

using namespace croquis::test;

constexpr std::array all_kernels = {Kernel::Hermite, Kernel::Triharmonic, Kernel::Biharmonic, Kernel::ThinPlate};
constexpr std::array value_kernels = {Kernel::Triharmonic, Kernel::Biharmonic, Kernel::ThinPlate};

FitOptions exact(Kernel kernel) { return {kernel, 0, 0, 0}; }

double linear(const Vec3& p) { return 2 + p.x() - 3 * p.y() + 0.5 * p.z(); }

double angle_degrees(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI; }

TEST_CASE("values of a linear function are reproduced without any weight") {
  for (const Kernel kernel : value_kernels) {
    Constraints data;
    data.positions = random_points(20, 5);
    for (const Vec3& p : data.positions) data.values.push_back(linear(p));
    const LocalFit fit(data, exact(kernel));
    for (const double weight : fit.value_weights()) CHECK(std::abs(weight) < 1e-10);
    CHECK((fit.polynomial() - Eigen::Vector4d(2, 1, -3, 0.5)).norm() < 1e-10);
    CHECK(fit.report().polynomial_rank == 4);
    CHECK_FALSE(fit.report().rank_revealing);
    const Vec3 place(3, 2, -1);
    CHECK(fit.value(place) == Approx(linear(place)).epsilon(1e-10));
  }
}

TEST_CASE("points and normals of a plane give the plane without any weight") {
  Constraints data;
  data.positions = random_points(40, 6);
  for (Vec3& p : data.positions) p.z() = 0;
  data.gradients.assign(40, Vec3::UnitZ());
  for (const FitOptions& options : {exact(Kernel::Hermite), FitOptions{}}) {
    const LocalFit fit(data, options);
    for (const double weight : fit.value_weights()) CHECK(std::abs(weight) < 1e-10);
    for (const Vec3& weight : fit.gradient_weights()) CHECK(weight.norm() < 1e-10);
    CHECK((fit.polynomial() - Eigen::Vector4d(0, 0, 0, 1)).norm() < 1e-10);
  }
}

TEST_CASE("200 points and normals of a sphere give it to 1e-5 and its normals to a hundredth of a degree") {
  const Constraints data = sphere_points(200, Vec3::Zero(), 1);
  const LocalFit fit(data, exact(Kernel::Hermite));
  double worst_value = 0;
  double worst_angle = 0;
  for (const Vec3& p : sphere_points(1000, Vec3::Zero(), 1).positions) {
    worst_value = std::max(worst_value, std::abs(fit.value(p)));
    worst_angle = std::max(worst_angle, angle_degrees(fit.gradient(p), p));
  }
  INFO(worst_value << ", " << worst_angle << " degrees");
  CHECK(worst_value < 1e-5);
  CHECK(worst_angle < 0.01);
}

TEST_CASE("the usual smoothing keeps a sphere to a thousandth of its radius") {
  const LocalFit fit(sphere_points(200, Vec3::Zero(), 1), {});
  for (const Vec3& p : sphere_points(500, Vec3::Zero(), 1).positions) CHECK(std::abs(fit.value(p)) < 1e-3);
}

TEST_CASE("without smoothing every kernel interpolates and keeps its side conditions") {
  for (const Kernel kernel : all_kernels) {
    Constraints data = ellipsoid_points(150, Vec3(1, 0.7, 0.4));
    Random random(8);
    for (std::size_t i = 0; i < data.size(); ++i) data.values.push_back(0.1 * random.between(-1, 1));
    const LocalFit fit(data, exact(kernel));
    const auto a = fit.value_weights();
    const double size = bounds(data.positions).size().maxCoeff();
    const auto b = fit.gradient_weights();
    double constant = 0;
    Vec3 first = Vec3::Zero();
    for (std::size_t i = 0; i < data.size(); ++i) {
      CHECK(std::abs(fit.value(data.positions[i]) - data.values[i]) < 1e-8);
      if (kernel == Kernel::Hermite) CHECK((fit.gradient(data.positions[i]) - data.gradients[i]).norm() < 1e-8);
      constant += a[i];
      first += a[i] * data.positions[i] / size;  // as in the unit box
      if (!b.empty()) first += b[i];
    }
    double largest = 0;
    for (const double weight : a) largest = std::max(largest, std::abs(weight));
    CHECK(std::abs(constant) < 1e-8 * largest);
    CHECK(first.norm() < 1e-8 * largest);
  }
}

TEST_CASE("gradients of fits agree with finite differences") {
  for (const Kernel kernel : all_kernels) {
    Constraints data = ellipsoid_points(90, Vec3(3, 2, 1));
    if (kernel != Kernel::Hermite)
      for (std::size_t i = 0; i < data.size(); ++i) data.values.push_back(std::sin(static_cast<double>(i)));
    const LocalFit fit(data, {kernel, 1, 5, 0});
    for (const Vec3& unit : random_points(50, 9)) {
      const Vec3 p = 3 * unit;
      const Vec3 gradient = fit.gradient(p);
      Vec3 slopes;
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 aside = 1e-5 * Vec3::Unit(axis);
        slopes[axis] = (fit.value(p + aside) - fit.value(p - aside)) / 2e-5;
      }
      CHECK((slopes - gradient).norm() < 1e-5 * gradient.norm());
    }
  }
}

TEST_CASE("centres without gradients, wherever they stand, are met by their values") {
  for (const Kernel kernel : {Kernel::Hermite, Kernel::HermiteQuintic}) {
    Constraints data = ellipsoid_points(75, Vec3(3, 2, 1));
    for (std::size_t i = 0; i < data.size(); ++i) {
      data.values.push_back(0.1 * std::sin(static_cast<double>(i)));
      if (i % 3 != 1) data.gradients[i].setZero();
    }
    const LocalFit fit(data, exact(kernel));
    CHECK(fit.report().unknowns == 75 + 3 * 25);
    std::vector<double> values(data.size());
    std::vector<Vec3> gradients(data.size());
    fit.evaluate(data.positions, values, gradients);
    for (std::size_t i = 0; i < data.size(); ++i) {
      CHECK(std::abs(values[i] - data.values[i]) < 1e-8);
      if (i % 3 == 1) CHECK((gradients[i] - data.gradients[i]).norm() < 1e-7);
      CHECK(fit.value(data.positions[i]) == values[i]);
    }
    for (const Vec3& unit : random_points(50, 9)) {
      const Vec3 p = 3 * unit, gradient = fit.gradient(p);
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 aside = 1e-5 * Vec3::Unit(axis);
        const double slope = (fit.value(p + aside) - fit.value(p - aside)) / 2e-5;
        CHECK(slope == Approx(gradient[axis]).margin(1e-5 * gradient.norm()));
      }
    }
  }
}

TEST_CASE("a fit far from the origin or tiny is the same fit") {
  const Constraints data = ellipsoid_points(120, Vec3(1, 0.8, 0.6));
  const LocalFit fit(data, {});
  for (const double scale : {1.0, 1e-3, 1e3}) {
    for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(1e6 * scale, -1e6 * scale, 1e6 * scale)}) {
      Constraints moved = data;
      for (Vec3& p : moved.positions) p = scale * p + shift;
      const LocalFit other(moved, {});
      for (const Vec3& p : random_points(100, 10)) {
        CHECK(std::abs(other.value(scale * p + shift) / scale - fit.value(p)) < 1e-6);
        CHECK((other.gradient(scale * p + shift) - fit.gradient(p)).norm() < 1e-6 * fit.gradient(p).norm());
      }
    }
  }
}

TEST_CASE("turning the points turns the fit") {
  const Constraints data = ellipsoid_points(120, Vec3(1, 0.8, 0.6));
  const LocalFit fit(data, exact(Kernel::Hermite));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  Constraints turned = data;
  for (Vec3& p : turned.positions) p = turn * p;
  for (Vec3& n : turned.gradients) n = turn * n;
  const LocalFit other(turned, exact(Kernel::Hermite));
  for (const Vec3& p : random_points(100, 11)) CHECK(std::abs(other.value(turn * p) - fit.value(p)) < 1e-8);
}

TEST_CASE("points at one place are merged and counted") {
  Constraints data = sphere_points(60, Vec3::Zero(), 1);
  data.positions.push_back(data.positions[7]);
  data.gradients.push_back(data.gradients[7]);
  for (const Kernel kernel : all_kernels) {
    const LocalFit fit(data, exact(kernel));
    CHECK(fit.report().merged == 1);
    CHECK(fit.report().centres == 60);
    CHECK_FALSE(fit.report().rank_revealing);
    CHECK(std::isfinite(fit.value(Vec3(0.3, 0.2, 0.1))));
  }
}

/// Any quadratic, and its gradient.
double quadratic(const Vec3& p) { return p.x() * p.x() - 2 * p.y() * p.z() + 3 * p.z() * p.z() + p.x() * p.z() - 1; }
Vec3 slope_of_quadratic(const Vec3& p) { return {2 * p.x() + p.z(), -2 * p.z(), -2 * p.y() + 6 * p.z() + p.x()}; }

TEST_CASE("values and gradients of a quadratic give it everywhere by the quintic kernel, without any weight") {
  for (const FitOptions& options : {exact(Kernel::HermiteQuintic), FitOptions{Kernel::HermiteQuintic, 1, 1000, 0}}) {
    Constraints data;
    data.positions = random_points(30, 5);
    for (const Vec3& p : data.positions) {
      data.values.push_back(quadratic(p));
      data.gradients.push_back(slope_of_quadratic(p));
    }
    const LocalFit fit(data, options);
    CHECK_FALSE(fit.report().rank_revealing);
    CHECK(fit.report().polynomial_rank == 10);
    for (const double weight : fit.value_weights()) CHECK(std::abs(weight) < 1e-7);
    for (const Vec3& p : random_points(50, 6)) {
      CHECK(std::abs(fit.value(3 * p) - quadratic(3 * p)) < 1e-7);
      CHECK((fit.gradient(3 * p) - slope_of_quadratic(3 * p)).norm() < 1e-7);
    }
  }
}

TEST_CASE("fewer than four centres without normals have a constant term alone") {
  for (const Kernel kernel : all_kernels) {
    for (std::size_t count = 1; count <= 3; ++count) {
      Constraints data;
      data.positions = random_points(count, 12);
      data.values = {0.5, -0.25, 1};
      data.values.resize(count);
      const LocalFit fit(data, exact(kernel));
      CHECK(fit.report().polynomial_rank == 1);
      CHECK(fit.polynomial().tail(3).norm() == 0);
      for (std::size_t i = 0; i < count; ++i)
        CHECK(fit.value(data.positions[i]) == Approx(data.values[i]).margin(1e-10));
    }
  }
}

TEST_CASE("centres in one plane, on one line or at one place are fitted too") {
  Random random(13);
  for (const Kernel kernel : all_kernels) {
    for (int dimension = 0; dimension < 3; ++dimension) {
      Constraints data;
      for (int i = 0; i < 25; ++i) {
        Vec3 p = Vec3(1, 2, 3);
        if (dimension > 0) p += random.unit() * Vec3(1, 1, 0.3);
        if (dimension > 1) p += random.unit() * Vec3(0, -1, 2);
        data.positions.push_back(p);
        data.values.push_back(std::sin(5 * p.x() + 3 * p.z()));
      }
      const LocalFit fit(data, exact(kernel));
      INFO("dimension " << dimension << ", kernel " << static_cast<int>(kernel));
      CHECK(fit.report().polynomial_rank == dimension + 1);
      for (std::size_t i = 0; i < data.size(); ++i)
        CHECK(fit.value(data.positions[i]) == Approx(data.values[i]).margin(1e-7));
    }
  }
}

TEST_CASE("a single point with its normal gives its plane") {
  const LocalFit fit({{Vec3(1, 2, 3)}, {}, {Vec3::UnitX()}}, {});
  CHECK(fit.value(Vec3(4, 7, -2)) == Approx(3));
  CHECK(fit.gradient(Vec3(9, 9, 9)).isApprox(Vec3::UnitX()));
}

TEST_CASE("one point or many at once, the bits are the same") {
  const LocalFit fit(sphere_points(77, Vec3::Zero(), 1), {});
  const std::vector<Vec3> places = random_points(200, 14);
  std::vector<double> values(200), without(200);
  std::vector<Vec3> gradients(200);
  fit.evaluate(places, values, gradients);
  fit.evaluate(places, without);
  for (std::size_t i = 0; i < 200; ++i) {
    CHECK(values[i] == fit.value(places[i]));
    CHECK(values[i] == without[i]);
    CHECK(gradients[i] == fit.gradient(places[i]));
  }
}

TEST_CASE("smoothing means the same at any scale and evens noise out") {
  Constraints data = sphere_points(200, Vec3::Zero(), 1);
  Random random(15);
  for (Vec3& p : data.positions) p *= 1 + 0.02 * random.between(-1, 1);
  const auto mean_error = [&](double strength) {
    const LocalFit fit(data, {Kernel::Hermite, strength, strength, 0});
    double sum = 0;
    for (const Vec3& p : sphere_points(500, Vec3::Zero(), 1).positions) sum += std::abs(fit.value(p));
    return sum / 500;
  };
  CHECK(mean_error(10) < 0.6 * mean_error(0));
}

TEST_CASE("a fit around a missing cap of a sphere closes it") {
  Constraints ring;  // what is left of a sphere beside a hole of 30 degrees
  const Constraints sphere = sphere_points(1500, Vec3::Zero(), 1);
  for (std::size_t i = 0; i < sphere.size(); ++i) {
    const double angle = std::acos(sphere.positions[i].z()) * 180 / M_PI;
    if (angle < 30 || angle > 55) continue;
    ring.positions.push_back(sphere.positions[i]);
    ring.gradients.push_back(sphere.gradients[i]);
  }
  REQUIRE(ring.size() < 250);
  const LocalFit fit(ring, {});
  double worst = 0;
  double sum = 0;
  int count = 0;
  for (const Vec3& start : sphere.positions) {
    if (start.z() < std::cos(M_PI / 6)) continue;
    Vec3 p = start;
    for (int step = 0; step < 20; ++step) p -= fit.value(p) / fit.gradient(p).squaredNorm() * fit.gradient(p);
    worst = std::max(worst, std::abs(p.norm() - 1));
    sum += std::abs(p.norm() - 1);
    ++count;
  }
  INFO("radial error up to " << worst << ", mean " << sum / count);
  CHECK(worst <= 0.009);
  CHECK(sum / count <= 0.004);
}

TEST_CASE("smoothing below nothing is refused") {
  const Constraints data = sphere_points(20, Vec3::Zero(), 1);
  CHECK_THROWS_AS(LocalFit(data, {Kernel::Hermite, -1, 0, 0}), Error);
  CHECK_THROWS_AS(LocalFit(data, {Kernel::Hermite, 0, NAN, 0}), Error);
  CHECK_THROWS_AS(LocalFit(data, {Kernel::Hermite, 0, 0, INFINITY}), Error);
}

TEST_CASE("unusable constraints are refused by name") {
  const auto code = [](const Constraints& data) {
    try {
      LocalFit(data, {});
    } catch (const Error& error) {
      return error.findings().front().code;
    }
    return std::string("none");
  };
  CHECK(code({}) == "E_NO_POINTS");
  CHECK(code({{Vec3(0, NAN, 0)}, {}, {}}) == "E_NOT_FINITE");
  CHECK(code({{Vec3(0, 1, 0)}, {INFINITY}, {}}) == "E_NOT_FINITE");
  CHECK(code({{Vec3(0, 1, 0)}, {}, {Vec3(0, 0, NAN)}}) == "E_NOT_FINITE");
  CHECK(code({{Vec3(0, 1, 0)}, {1, 2}, {}}) == "E_COUNT");
}

}  // namespace
}  // namespace croquis::implicit
