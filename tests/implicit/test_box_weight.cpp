// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/implicit/box_weight.h"
#include "implicit/sample_points.h"

namespace croquis::implicit {
namespace {

const Box unit_box = {Vec3::Zero(), Vec3::Ones()};

TEST_CASE("distances and weights of a unit box have their known values") {
  CHECK(box_distance(unit_box, Vec3(.5, .5, .5)) == 0);
  CHECK(box_weight(unit_box, Vec3(.5, .5, .5)).value == 1);
  CHECK(box_distance(unit_box, Vec3(.25, .5, .5)) == .25);
  CHECK(box_weight(unit_box, Vec3(.25, .5, .5)).value == Approx(.896484375).epsilon(1e-15));
  CHECK(blend(.25) == .896484375);
  CHECK(box_distance(unit_box, Vec3(.25, .25, .25)) == .578125);
}

TEST_CASE("the blend falls from 1 to 0, evenly about one half, and ends flat") {
  CHECK(blend(.5) == .5);
  CHECK(blend(0) == 1);
  CHECK(blend(1) == 0);
  CHECK(blend_derivative(1) == 0);
  for (int i = 0; i <= 100; ++i) {
    const double d = i / 100.0;
    CHECK(std::abs(blend(d) + blend(1 - d) - 1) < 4e-15);
    CHECK(std::abs((blend(d + 1e-6) - blend(d - 1e-6)) / 2e-6 - blend_derivative(d)) < 1e-8);
  }
  // W'' at 1 from one side: the second difference goes to 0 with the step.
  CHECK(std::abs((blend(1 - 2e-3) - 2 * blend(1 - 1e-3) + blend(1)) / 1e-6) < 0.1);
}

TEST_CASE("outside its box a weight is zero, where the formula alone would not be") {
  CHECK(box_distance(unit_box, Vec3(-.1, -.1, .5)) == 1);
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

TEST_CASE("weights are twice continuously differentiable through the faces, with the gradient told") {
  const Box box = {Vec3(-.7, -.5, -.6), Vec3(.6, .8, .5)};
  for (const Vec3& p : test::random_points(500, 21)) {
    const BoxWeight weight = box_weight(box, p);
    CHECK((weight.value >= 0 && weight.value <= 1));
    CHECK(std::abs(weight.value - blend(box_distance(box, p))) < 1e-14);
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
