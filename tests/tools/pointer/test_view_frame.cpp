// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/tools/pointer/view_frame.h"
#include "support/random.h"
#include "tools/pointer/mesh_views.h"

namespace croquis {
namespace {

using test::TestCamera;

Vec3 random_place(test::Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

TestCamera random_camera(test::Random& random, bool perspective) {
  TestCamera camera;
  camera.perspective = perspective;
  camera.eye = Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)).normalized() * 6;
  camera.target = random_place(random, 0.5);
  camera.half_height = perspective ? random.between(0.2, 0.8) : random.between(1, 4);
  camera.size = {random.between(300, 2000), random.between(300, 1500)};
  return camera;
}

TEST_CASE("a view projects as similar triangles say") {
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const TestCamera camera = random_camera(random, i % 2 == 0);
    const Vec3 place = random_place(random, 2);
    const auto seen = camera.frame().project(place);
    REQUIRE(seen);
    CHECK((seen->pixel - camera.pixel_of(place)).norm() < 1e-8);
    CHECK(std::abs(seen->depth) < 1);
  }
}

TEST_CASE("the ray through a pixel meets what the view shows there") {
  test::Random random(2);
  for (int i = 0; i < 200; ++i) {
    const TestCamera camera = random_camera(random, i % 2 == 0);
    const ViewFrame frame = camera.frame();
    const Vec3 place = random_place(random, 2);
    const auto seen = frame.project(place);
    REQUIRE(seen);
    const Ray ray = frame.ray(seen->pixel);
    const Vec3 offset = place - ray.origin;
    CHECK(ray.direction.norm() == Approx(1));
    CHECK(offset.cross(ray.direction).norm() < 1e-8);
    CHECK(offset.dot(ray.direction) > 0);
    CHECK((frame.unproject(seen->pixel, seen->depth) - place).norm() < 1e-8);
  }
}

TEST_CASE("a pixel's length at a place is what a step across the view takes") {
  test::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const TestCamera camera = random_camera(random, i % 2 == 0);
    const ViewFrame frame = camera.frame();
    const Vec3 place = random_place(random, 2);
    const double unit = frame.units_per_pixel(place);
    const auto before = frame.project(place);
    const auto after = frame.project(place + 10 * unit * camera.right());
    REQUIRE(before);
    REQUIRE(after);
    CHECK((after->pixel - before->pixel - Vec2(10, 0)).norm() < 1e-6);
    CHECK((frame.right() - camera.right()).norm() < 1e-9);
    CHECK((frame.up() - camera.upward()).norm() < 1e-9);
    const Vec3 eye = camera.perspective ? Vec3((camera.eye - place).normalized()) : Vec3(-camera.forward());
    CHECK((frame.to_eye(place) - eye).norm() < 1e-9);
  }
}

TEST_CASE("what lies beside or behind the eye has no place in a perspective view") {
  const ViewFrame frame = TestCamera().frame();
  CHECK_FALSE(frame.project({0, 0, 6}));
  CHECK_FALSE(frame.project({3, 0, 5}));
  CHECK(frame.units_per_pixel({0, 0, 6}) == 0);
  CHECK(frame.project({0, 0, 4}));
}

}  // namespace
}  // namespace croquis
