// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/tools/measure/measure_tool.h"

namespace croquis::test {
namespace {

/// A rotation, a mirror now and then, and a shift.
Eigen::Affine3d random_motion(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  motion.translate(10 * Vec3(number(random), number(random), number(random)));
  motion.rotate(Eigen::AngleAxisd(3 * number(random), Vec3(number(random), number(random), 1.5).normalized()));
  if (number(random) > 0) motion.scale(Vec3(-1, 1, 1));
  return motion;
}

TEST_CASE("measured circles and angles are those they were made with, wherever they lie") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.05, 0.95);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Affine3d motion = random_motion(random);
    const double radius = std::pow(10, 6 * share(random) - 3);
    const double first = 2 * std::numbers::pi * share(random);
    const double second = first + 2 * share(random), third = second + 2 * share(random);
    const auto on_circle = [&](double angle) {
      return Vec3(motion * (radius * Vec3(std::cos(angle), std::sin(angle), 0)));
    };
    const Vec3 a = on_circle(first), b = on_circle(second), c = on_circle(third);
    CHECK(radius_through(a, b, c) == Approx(radius).epsilon(1e-6));
    // An inscribed angle is half of the arc that it doesn't see.
    CHECK(angle_at(a, b, c) == Approx(180 - (third - first) / 2 * 180 / std::numbers::pi).margin(1e-5));
  }
}

TEST_CASE("places on a line have an infinite radius, places that fall together an angle of zero") {
  CHECK(std::isinf(radius_through({0, 0, 0}, {1, 1, 1}, {3, 3, 3})));
  CHECK(std::isinf(radius_through({1, 2, 3}, {1, 2, 3}, {1, 2, 3})));
  CHECK(angle_at({1, 0, 0}, {1, 0, 0}, {5, 5, 5}) == 0);
  CHECK(angle_at({1, 0, 0}, {0, 0, 0}, {-2, 0, 0}) == Approx(180));
  const auto values = measured({{0, 0, 0}, {3, 4, 0}});
  REQUIRE(values.size() == 1);
  CHECK(values[0].value == 5);
  CHECK(measured({}).empty());
  CHECK(measured({{1, 1, 1}}).empty());
  CHECK(measured_text({{0, 0, 0}, {3, 4, 0}, {3, 4, 12}}) ==
        "Distance: 5 (x 3, y 4, z 0)\nDistance: 12 (x 0, y 0, z 12)\nAngle: 90°\nRadius: 6.5\n");
}

/// A view straight down on the plane z = 0, a unit a pixel.
ViewFrame sheet() {
  Eigen::Matrix4d to_clip = Eigen::Matrix4d::Identity();
  to_clip(0, 0) = to_clip(1, 1) = 0.01;
  to_clip(2, 2) = -0.001;
  return ViewFrame::of(to_clip, {200, 200});
}

struct Hand {
  MeasureTool tool{[](const ViewFrame& frame, const Vec2& pixel) -> std::optional<Vec3> {
    const Vec3 place = frame.unproject(pixel, 0);
    if (place.norm() > 90) return std::nullopt;  // the model is a disc
    return Vec3(place.x(), place.y(), 0);
  }};

  bool event(PenStep::Kind kind, const Vec2& pixel) { return tool.handle({kind, pixel, {}, sheet(), 0}); }
  bool click(const Vec2& pixel) {
    event(PenStep::Kind::Begin, pixel);
    return event(PenStep::Kind::End, pixel);
  }
};

TEST_CASE("clicks add places, the fourth begins anew, drags move them, and a drag that is given up does nothing") {
  Hand hand;
  CHECK(hand.click({100, 100}));
  CHECK(hand.tool.places().size() == 1);
  CHECK(hand.tool.places()[0].norm() < 1e-9);
  CHECK(hand.click({150, 100}));
  CHECK(hand.tool.places()[1].x() == Approx(50));
  CHECK_FALSE(hand.click({199, 1}));  // beside the model
  CHECK(hand.tool.places().size() == 2);

  hand.event(PenStep::Kind::Begin, {151, 101});
  hand.event(PenStep::Kind::Sample, {140, 100});
  CHECK(hand.event(PenStep::Kind::End, {140, 100}));
  CHECK(hand.tool.places()[1].x() == Approx(40));
  hand.event(PenStep::Kind::Begin, {140, 100});
  hand.event(PenStep::Kind::Sample, {120, 100});
  hand.event(PenStep::Kind::Cancel, Vec2::Zero());
  CHECK(hand.tool.places()[1].x() == Approx(40));

  CHECK(hand.click({100, 50}));
  CHECK(hand.tool.places().size() == 3);
  CHECK(hand.click({60, 60}));
  CHECK(hand.tool.places().size() == 1);
  CHECK(hand.tool.remove_last());
  CHECK_FALSE(hand.tool.remove_last());
}

}  // namespace
}  // namespace croquis::test
