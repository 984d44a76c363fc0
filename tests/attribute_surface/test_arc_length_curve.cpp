// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/geometry/attribute_network.h"

using namespace croquis;

namespace {

using Control = std::vector<Vec3>;

Control random_control(std::mt19937& random, std::size_t degree) {
  std::normal_distribution<double> normal;
  Control control;
  for (std::size_t i = 0; i <= degree; ++i)
    control.emplace_back(normal(random) + 2.0 * static_cast<double>(i), normal(random), normal(random));
  return control;
}

/// Length of the curve from its start to t by very many chords, with Richardson's step.
double length_by_chords(const Control& control, double t) {
  const auto chords = [&](int count) {
    double sum = 0;
    Vec3 before = control.front();
    for (int i = 1; i <= count; ++i) {
      const Vec3 point = bezier_point(control, t * i / count);
      sum += (point - before).norm();
      before = point;
    }
    return sum;
  };
  return (4 * chords(4000) - chords(2000)) / 3;
}

}  // namespace

TEST_CASE("lengths are those of fine chords") {
  std::mt19937 random(1);
  for (std::size_t degree = 1; degree <= 9; ++degree) {
    const Control control = random_control(random, degree);
    const ArcLengthCurve curve(control);
    CHECK(curve.length() == Approx(length_by_chords(control, 1)).epsilon(1e-9));
    CHECK(bezier_length(control) == Approx(curve.length()).epsilon(1e-14));
  }
}

TEST_CASE("fractions of the arc length divide the curve") {
  std::mt19937 random(2);
  for (std::size_t degree = 1; degree <= 7; ++degree) {
    const Control control = random_control(random, degree);
    const ArcLengthCurve curve(control);
    for (const double s : {0.01, 0.2, 0.5, 0.77, 0.999}) {
      const double t = curve.parameter(s);
      CHECK(curve.fraction(t) == Approx(s).margin(1e-12));
      CHECK((curve.at(s) - bezier_point(control, t)).norm() < 1e-13 * curve.length());
      CHECK(length_by_chords(control, t) == Approx(s * curve.length()).epsilon(1e-8));
    }
  }
}

TEST_CASE("the middle of a curve that is its own mirror image is at the middle of its parameter") {
  std::mt19937 random(6);
  for (int run = 0; run < 50; ++run) {
    Control control = random_control(random, 3);
    for (std::size_t i = 0; i < 2; ++i) control[3 - i] = {-control[i].x(), control[i].y(), control[i].z()};
    const ArcLengthCurve curve(control);
    CHECK(curve.parameter(0.5) == Approx(0.5).margin(1e-14));
    CHECK(std::abs(curve.at(0.5).x()) < 1e-12 * curve.length());
  }
}

TEST_CASE("ends are the control points, bit for bit") {
  std::mt19937 random(3);
  for (std::size_t degree = 1; degree <= 7; ++degree) {
    const ArcLengthCurve curve(random_control(random, degree));
    CHECK(curve.at(0) == curve.control().front());
    CHECK(curve.at(1) == curve.control().back());
    CHECK(curve.place(0).point == curve.control().front());
  }
}

TEST_CASE("derivatives are as long as the curve and point along it") {
  std::mt19937 random(4);
  for (std::size_t degree = 1; degree <= 7; ++degree) {
    const ArcLengthCurve curve(random_control(random, degree));
    constexpr double h = 1e-5;
    for (const double s : {0.1, 0.5, 0.9}) {
      const Vec3 difference = (curve.at(s + h) - curve.at(s - h)) / (2 * h);
      CHECK((curve.place(s).derivative - difference).norm() < 1e-6 * curve.length());
      CHECK(curve.place(s).derivative.norm() == Approx(curve.length()).epsilon(1e-10));
    }
    CHECK((curve.start_derivative() - (curve.at(h) - curve.at(0)) / h).norm() < 1e-3 * curve.length());
    CHECK((curve.end_derivative() - (curve.at(1) - curve.at(1 - h)) / h).norm() < 1e-3 * curve.length());
  }
}

TEST_CASE("a curve walked along backwards is divided alike") {
  std::mt19937 random(5);
  for (std::size_t degree = 2; degree <= 7; ++degree) {
    const Control control = random_control(random, degree);
    const ArcLengthCurve curve(control);
    const ArcLengthCurve back(Control(control.rbegin(), control.rend()));
    for (const double s : {0.1, 0.4, 0.83}) CHECK((curve.at(s) - back.at(1 - s)).norm() < 1e-12 * curve.length());
  }
}

TEST_CASE("curves that stand still have a direction and are divided evenly") {
  const std::vector<Control> controls{
      {{0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {2, 0, 0}},             // at the start
      {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}, {2, 0, 1}},             // at the end
      {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}},             // at both, straight
      {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}},             // a cusp in the middle
      {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {2, 0, 0}},  // more than once
  };
  for (const Control& control : controls) {
    const ArcLengthCurve curve(control);
    for (int i = 0; i <= 20; ++i) {
      const ArcLengthCurve::Place place = curve.place(i / 20.0);
      CHECK(place.derivative.norm() == Approx(curve.length()).epsilon(1e-9));
      if (i > 0 && i < 20) {
        CHECK(length_by_chords(control, curve.parameter(i / 20.0)) == Approx(curve.length() * i / 20.0).epsilon(1e-5));
      }
    }
  }
}
