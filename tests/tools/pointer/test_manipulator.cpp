// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/tools/pointer/manipulator.h"
#include "support/random.h"
#include "tools/pointer/mesh_views.h"

namespace croquis {
namespace {

using test::TestCamera;
using Handle = ManipulatorHandle;

Manipulator manipulator(ManipulatorKind kind, const Vec3& pivot = Vec3::Zero()) {
  Manipulator result;
  result.kind = kind;
  result.pivot = pivot;
  return result;
}

TestCamera oblique(bool perspective = true) {
  TestCamera camera;
  camera.eye = {3, 2.5, 4};
  camera.perspective = perspective;
  if (!perspective) camera.half_height = 2;
  return camera;
}

TEST_CASE("handles are found where they are drawn, in every view and at every distance") {
  test::Random random(20);
  for (int round = 0; round < 60; ++round) {
    TestCamera camera = oblique(round % 2 == 0);
    camera.eye = camera.eye * random.between(0.5, 10);
    const Vec3 pivot(random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-0.5, 0.5));
    const ViewFrame frame = camera.frame();
    const double unit = 80 * frame.units_per_pixel(pivot);
    const Manipulator move = manipulator(ManipulatorKind::Move, pivot);
    const auto at = [&](const Vec3& place) { return camera.pixel_of(pivot + unit * place); };
    CHECK(handle_at(move, frame, at({0.8, 0, 0})) == Handle::X);
    CHECK(handle_at(move, frame, at({0, 0.8, 0})) == Handle::Y);
    CHECK(handle_at(move, frame, at({0, 0, 0.8})) == Handle::Z);
    CHECK(handle_at(move, frame, at({0, 0, 0})) == Handle::Centre);
    CHECK(handle_at(move, frame, at({0, 0, 0}) + Vec2(300, 0)) == Handle::None);
    const Manipulator turn = manipulator(ManipulatorKind::Rotate, pivot);
    CHECK(handle_at(turn, frame, camera.pixel_of(pivot) + Vec2(0, 96)) == Handle::View);
    CHECK(handle_at(turn, frame, camera.pixel_of(pivot) + Vec2(0, 130)) == Handle::None);
    CHECK(handle_at(manipulator(ManipulatorKind::None, pivot), frame, camera.pixel_of(pivot)) == Handle::None);
  }
}

TEST_CASE("every part of the picture is as long on the screen as it should be") {
  for (const double distance : {1.0, 20.0}) {
    TestCamera camera = oblique();
    camera.eye *= distance;
    const ViewFrame frame = camera.frame();
    for (const ManipulatorKind kind : {ManipulatorKind::Move, ManipulatorKind::Rotate, ManipulatorKind::Scale}) {
      const ManipulatorPicture seen = picture(manipulator(kind), frame, Handle::X, Handle::None);
      CHECK_FALSE(seen.lines.empty());
      double furthest = 0;
      std::set<HandleState> states;
      for (const ManipulatorLine& line : seen.lines) {
        states.insert(line.state);
        for (const Vec3& point : line.points)
          furthest = std::max(furthest, (camera.pixel_of(point) - camera.pixel_of(Vec3::Zero())).norm());
      }
      CHECK(states == std::set<HandleState>{HandleState::Normal, HandleState::Hovered});
      CHECK(furthest > 60);
      CHECK(furthest < 110);
    }
  }
}

TEST_CASE("planes and the free handle carry a place to where the pointer is") {
  const TestCamera camera = oblique();
  const ViewFrame frame = camera.frame();
  const Vec3 from(0.2, 0.3, 0);
  const Vec3 to(-0.5, 0.9, 0);
  ManipulatorDrag in_plane(manipulator(ManipulatorKind::Move), Handle::XY, camera.pixel_of(from));
  CHECK((in_plane.to(frame, camera.pixel_of(to)).by - (to - from)).norm() < 1e-9);
  ManipulatorDrag freely(manipulator(ManipulatorKind::Move, {0.1, 0.2, 0.3}), Handle::Centre,
                         camera.pixel_of({0.1, 0.2, 0.3}));
  const Vec2 target = camera.pixel_of({0.1, 0.2, 0.3}) + Vec2(40, 25);
  const ManipulatorMotion& motion = freely.to(frame, target);
  CHECK((camera.pixel_of(Vec3(0.1, 0.2, 0.3) + motion.by) - target).norm() < 1e-9);
  CHECK(std::abs(motion.by.dot(camera.forward())) < 1e-9);
}

TEST_CASE("turning about an axis follows the pointer and counts on beyond full turns") {
  for (const bool perspective : {true, false}) {
    const TestCamera camera = oblique(perspective);
    const ViewFrame frame = camera.frame();
    const auto on_ring = [&](double degrees) {
      const double angle = degrees * 3.14159265358979323846 / 180;
      return camera.pixel_of(0.3 * Vec3(0, std::cos(angle), std::sin(angle)));
    };
    ManipulatorDrag drag(manipulator(ManipulatorKind::Rotate), Handle::X, on_ring(20));
    for (int degrees = 20; degrees <= 20 + 800; degrees += 10) drag.to(frame, on_ring(degrees));
    CHECK(drag.motion().degrees == Approx(800).epsilon(1e-9));
    CHECK((drag.motion().axis - Vec3::UnitX()).norm() < 1e-12);
    for (int degrees = 820; degrees >= 65; degrees -= 5) drag.to(frame, on_ring(degrees));
    CHECK(drag.motion().degrees == Approx(45).epsilon(1e-9));
    const Vec3 turned = drag.motion().map * Vec3(5, 1, 0);
    CHECK((turned - Vec3(5, std::sqrt(0.5), std::sqrt(0.5))).norm() < 1e-9);
    ManipulatorSnap snap;
    snap.degrees = 15;
    CHECK(drag.to(frame, on_ring(20 + 52), snap).degrees == Approx(45));
  }
}

TEST_CASE("about the view's direction the picture turns as the pointer does") {
  const TestCamera camera = oblique();
  const ViewFrame frame = camera.frame();
  const Vec2 middle = camera.pixel_of(Vec3::Zero());
  ManipulatorDrag drag(manipulator(ManipulatorKind::Rotate), Handle::View, middle + Vec2(96, 0));
  for (int degrees = 10; degrees <= 450; degrees += 10) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    drag.to(frame, middle + 96 * Vec2(std::cos(angle), -std::sin(angle)));
  }
  CHECK(drag.motion().degrees == Approx(450));
  // A quarter turn (and one whole): what was to the right is above.
  const Vec2 seen = camera.pixel_of(drag.motion().map * (0.01 * camera.right())) - middle;
  CHECK(std::abs(seen.x()) < 0.01);
  CHECK(seen.y() < -0.5);
}

TEST_CASE("a ring seen from its edge turns by pulling along it, the near side with the pointer") {
  TestCamera camera;
  camera.eye = {0, 0, 5};
  const ViewFrame frame = camera.frame();
  const Vec2 middle = camera.pixel_of(Vec3::Zero());
  // About y, seen from its edge: pulling right turns the near side to the right.
  ManipulatorDrag drag(manipulator(ManipulatorKind::Rotate), Handle::Y, middle);
  const ManipulatorMotion& motion = drag.to(frame, middle + Vec2(40, 0));
  CHECK(motion.degrees == Approx(0.5 * 180 / 3.14159265358979323846));
  CHECK((motion.map * Vec3::UnitZ()).x() > 0.4);
  ManipulatorDrag ball(manipulator(ManipulatorKind::Rotate), Handle::Centre, middle);
  const Vec3 near = ball.to(frame, middle + Vec2(20, 30)).map * Vec3::UnitZ();
  CHECK(near.x() > 0);
  CHECK(near.y() < 0);
}

TEST_CASE("scaling keeps the pivot and stretches along its axes alone") {
  const TestCamera camera = oblique();
  const ViewFrame frame = camera.frame();
  const Vec3 pivot(0.3, -0.2, 0.1);
  const double unit = 80 * frame.units_per_pixel(pivot);
  const auto on_axis = [&](double t) { return camera.pixel_of(pivot + t * unit * Vec3::UnitY()); };
  ManipulatorDrag drag(manipulator(ManipulatorKind::Scale, pivot), Handle::Y, on_axis(1));
  const ManipulatorMotion& motion = drag.to(frame, on_axis(2.5));
  CHECK((motion.factors - Vec3(1, 2.5, 1)).norm() < 1e-9);
  CHECK((motion.map * pivot - pivot).norm() < 1e-12);
  CHECK((motion.map * (pivot + Vec3(1, 1, 1)) - pivot - Vec3(1, 2.5, 1)).norm() < 1e-9);
  CHECK((drag.to(frame, on_axis(-9)).factors.array() > 0).all());
  ManipulatorDrag evenly(manipulator(ManipulatorKind::Scale, pivot), Handle::Centre, on_axis(0));
  CHECK((evenly.to(frame, on_axis(0) + Vec2(80, 0)).factors - Vec3(2, 2, 2)).norm() < 1e-12);
  ManipulatorDrag flat(manipulator(ManipulatorKind::Scale, pivot), Handle::YZ, on_axis(1));
  CHECK(flat.to(frame, on_axis(2)).factors.x() == 1);
}

TEST_CASE("snapping moves in whole steps") {
  const TestCamera camera = oblique();
  ManipulatorSnap snap;
  snap.move = 0.25;
  ManipulatorDrag drag(manipulator(ManipulatorKind::Move), Handle::X, camera.pixel_of({0.1, 0, 0}));
  CHECK((drag.to(camera.frame(), camera.pixel_of({0.7, 0, 0}), snap).by - Vec3(0.5, 0, 0)).norm() < 1e-12);
}

TEST_CASE("wherever the pointer goes every handle gives a finite, invertible map") {
  test::Random random(22);
  const std::vector<Vec3> eyes = {{0, 0, 5}, {5, 0, 0}, {0.001, 5, 0.001}, {3, 2, 4}, {0, 1e-9, -5}};
  for (const Vec3& eye : eyes) {
    for (const bool perspective : {true, false}) {
      TestCamera camera;
      camera.eye = eye;
      camera.perspective = perspective;
      camera.up = std::abs(eye.normalized().y()) > 0.9 ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::UnitY());
      const ViewFrame frame = camera.frame();
      for (const ManipulatorKind kind : {ManipulatorKind::Move, ManipulatorKind::Rotate, ManipulatorKind::Scale}) {
        for (int handle = static_cast<int>(Handle::X); handle <= static_cast<int>(Handle::View); ++handle) {
          ManipulatorDrag drag(manipulator(kind), static_cast<Handle>(handle), {400, 300});
          for (int i = 0; i < 40; ++i) {
            const double wide = i % 5 == 0 ? 1e6 : 900;
            const ManipulatorMotion& motion =
                drag.to(frame, {random.between(-wide, wide), random.between(-wide, wide)});
            REQUIRE(motion.map.matrix().allFinite());
            REQUIRE(std::abs(motion.map.linear().determinant()) > 1e-12);
          }
        }
      }
    }
  }
}

TEST_CASE("an axis that points into the view has no arrow, and behind the eye there is no manipulator") {
  TestCamera camera;
  camera.eye = {0, 0, 5};
  const ManipulatorPicture seen = picture(manipulator(ManipulatorKind::Move), camera.frame());
  for (const ManipulatorLine& line : seen.lines) {
    if (line.points.size() == 2) CHECK(line.role != ColourRole::Z);
  }
  CHECK(picture(manipulator(ManipulatorKind::Move, {0, 0, 9}), camera.frame()).lines.empty());
  CHECK(handle_at(manipulator(ManipulatorKind::Move, {0, 0, 9}), camera.frame(), {400, 300}) == Handle::None);
}

}  // namespace
}  // namespace croquis
