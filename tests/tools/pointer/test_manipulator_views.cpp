// SPDX-License-Identifier: GPL-3.0-or-later
// Every handle from every kind of camera: near, far and inside the model, with planes of depth fitted as views fit
// them.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/tools/pointer/manipulator.h"
#include "tools/pointer/mesh_views.h"

namespace croquis {
namespace {

using test::TestCamera;
using Handle = ManipulatorHandle;

constexpr double pull = 72;  // pixels
constexpr double radians = 3.14159265358979323846 / 180;

/// Planes of depth close around the cube [-1, 1]^3, as views have them.
TestCamera fitted(TestCamera camera) {
  const double radius = 1.01 * std::sqrt(3.0);
  const double middle = -camera.eye.dot(camera.forward());
  camera.near = middle - radius;
  camera.far = middle + radius;
  if (!camera.perspective) return camera;
  camera.far = std::max(camera.far, 1e-3 * radius);
  camera.near = std::max(camera.near, 1e-3 * camera.far);
  return camera;
}

struct Seen {
  std::string name;
  TestCamera camera;
};

std::vector<Seen> cameras() {
  std::vector<Seen> all;
  const auto add = [&](const std::string& name, const Vec3& eye, const Vec3& target, bool perspective, double height) {
    TestCamera camera;
    camera.eye = eye;
    camera.target = target;
    if (std::abs(camera.forward().y()) > 0.99) camera.up = -Vec3::UnitZ();
    camera.perspective = perspective;
    camera.half_height = height;
    all.push_back({name, fitted(camera)});
  };
  const double opening = std::tan(0.25);
  const Vec3 oblique = Vec3(0.62, 0.46, 1).normalized();
  for (const double distance : {8.0, 40.0}) add("perspective", distance * oblique, Vec3::Zero(), true, opening);
  add("close to a corner", Vec3(1.3, 1.25, 1.5), Vec3(0.9, 1, 0.9), true, opening);
  add("inside", Vec3(0.1, 0.2, 0.3), Vec3(1, 0.6, -0.9), true, opening);
  add("wide and inside", Vec3(-0.2, 0.1, 0.5), Vec3(0.4, -0.3, -1), true, 1);
  add("front", {0, 0, 9}, Vec3::Zero(), false, 1.6);
  add("side", {9, 0, 0}, Vec3::Zero(), false, 1.6);
  add("top", {0, 9, 0}, Vec3::Zero(), false, 1.6);
  add("front, near", {0.97, 0.97, 9}, {0.97, 0.97, 0}, false, 0.05);
  add("parallel from within", {0.2, 0.1, 0}, Vec3(0.2, 0.1, 0) - oblique, false, 1.6);
  return all;
}

std::vector<Vec3> places() {
  std::vector<Vec3> all{Vec3::Zero(), {0, 0, 1}, {0.3, -1, 0.4}};
  for (int k = 0; k < 8; ++k) all.emplace_back((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
  return all;
}

bool is_in_view(const TestCamera& camera, const Vec3& place) {
  if (camera.perspective && (place - camera.eye).dot(camera.forward()) < 0.05) return false;
  const Vec2 at = camera.pixel_of(place);
  return (at.array() > 0).all() && (at.array() < camera.size.array()).all();
}

Manipulator manipulator_at(ManipulatorKind kind, const Vec3& pivot) {
  Manipulator result;
  result.kind = kind;
  result.pivot = pivot;
  return result;
}

std::vector<Vec2> pulls() {
  std::vector<Vec2> all;
  for (int degrees = 0; degrees < 360; degrees += 45)
    all.push_back(pull * Vec2(std::cos(degrees * radians), std::sin(degrees * radians)));
  return all;
}

/// The pointer's place on the line on the screen along which a handle runs.
Vec2 on_line(const Vec2& pointer, const Vec2& point, const Vec2& along) {
  return point + (pointer - point).dot(along) * along;
}

/// A handle that runs along an axis, its place in lengths of the handles, and what carries it.
struct Grip {
  Handle handle;
  Vec3 place;
  bool in_plane;
};

const std::array<Grip, 6> grips = {{{Handle::X, {0.9, 0, 0}, false},
                                    {Handle::Y, {0, 0.9, 0}, false},
                                    {Handle::Z, {0, 0, 0.9}, false},
                                    {Handle::YZ, {0, 0.38, 0.38}, true},
                                    {Handle::ZX, {0.38, 0, 0.38}, true},
                                    {Handle::XY, {0.38, 0.38, 0}, true}}};

/// Pulls a handle of the move manipulator every way. @return how many pulls were looked at
int check_moves(const TestCamera& camera, const Vec3& pivot) {
  const ViewFrame frame = camera.frame();
  const Manipulator move = manipulator_at(ManipulatorKind::Move, pivot);
  const double unit = 80 * frame.units_per_pixel(pivot);
  int checked = 0;
  for (const Grip& grip : grips) {
    const Vec3 from = pivot + unit * grip.place;
    const Vec2 start = camera.pixel_of(from);
    if (handle_at(move, frame, start) != grip.handle) continue;  // it points into the view, or is covered
    const Vec2 along = (start - camera.pixel_of(pivot)).normalized();
    for (const Vec2& by : pulls()) {
      ManipulatorDrag drag(move, grip.handle, start);
      const Vec3 moved = drag.to(frame, start + by).by;
      const Vec2 wanted = grip.in_plane ? Vec2(start + by) : on_line(start + by, start, along);
      CAPTURE(static_cast<int>(grip.handle), by.transpose(), moved.transpose());
      CHECK((camera.pixel_of(from + moved) - wanted).norm() < 0.5);
      ++checked;
    }
  }
  return checked;
}

int check_scales(const TestCamera& camera, const Vec3& pivot) {
  const ViewFrame frame = camera.frame();
  const Manipulator scale = manipulator_at(ManipulatorKind::Scale, pivot);
  const double unit = 80 * frame.units_per_pixel(pivot);
  int checked = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 from = pivot + unit * Vec3::Unit(k);
    const Vec2 start = camera.pixel_of(from);
    const auto handle = static_cast<Handle>(static_cast<int>(Handle::X) + k);
    if (handle_at(scale, frame, start) != handle) continue;
    const Vec2 along = (start - camera.pixel_of(pivot)).normalized();
    ManipulatorDrag drag(scale, handle, start);
    CHECK((camera.pixel_of(drag.to(frame, start + pull * along).map * from) - start - pull * along).norm() < 0.5);
    const double half_way = (start - camera.pixel_of(pivot)).norm() / 2;
    CHECK((camera.pixel_of(drag.to(frame, start - half_way * along).map * from) - start + half_way * along).norm() <
          0.5);
    ++checked;
  }
  return checked;
}

int check_turns(const TestCamera& camera, const Vec3& pivot) {
  const ViewFrame frame = camera.frame();
  const Manipulator turn = manipulator_at(ManipulatorKind::Rotate, pivot);
  const double unit = 80 * frame.units_per_pixel(pivot);
  int checked = 0;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(frame.to_eye(pivot)[k]) < 0.35) continue;  // seen from its edge it follows no place
    const auto handle = static_cast<Handle>(static_cast<int>(Handle::X) + k);
    const auto on_ring = [&](double degrees) {
      const Vec3 a = Vec3::Unit((k + 1) % 3);
      const Vec3 b = Vec3::Unit((k + 2) % 3);
      return Vec3(pivot + unit * (std::cos(degrees * radians) * a + std::sin(degrees * radians) * b));
    };
    ManipulatorDrag drag(turn, handle, camera.pixel_of(on_ring(30)));
    for (int degrees = 40; degrees <= 120; degrees += 10) {
      const Vec3 carried = drag.to(frame, camera.pixel_of(on_ring(degrees))).map * on_ring(30);
      CHECK((camera.pixel_of(carried) - camera.pixel_of(on_ring(degrees))).norm() < 0.5);
    }
    ++checked;
  }
  return checked;
}

TEST_CASE("what a handle carries stays under the pointer, from any camera and at any place") {
  for (const Seen& seen : cameras()) {
    int moves = 0, scales = 0, turns = 0;
    for (const Vec3& place : places()) {
      if (!is_in_view(seen.camera, place)) continue;
      CAPTURE(seen.name, place.transpose());
      moves += check_moves(seen.camera, place);
      scales += check_scales(seen.camera, place);
      turns += check_turns(seen.camera, place);
    }
    INFO(seen.name);
    CHECK(moves >= 16);
    CHECK(scales >= 2);
    CHECK(turns >= 1);
  }
}

TEST_CASE("beyond the horizon a handle stays in front of the eye, wherever the pointer came from") {
  TestCamera camera;
  camera.eye = {0, 0.8, 5};
  camera = fitted(camera);
  const ViewFrame frame = camera.frame();
  const Vec2 start = camera.pixel_of({0.3, 0, 0.3});
  for (const Handle handle : {Handle::ZX, Handle::Z}) {
    const Vec2 beyond(500, 20);  // the plane y = 0 ends lower than that on the screen
    ManipulatorDrag at_once(manipulator_at(ManipulatorKind::Move, Vec3::Zero()), handle, start);
    ManipulatorDrag in_steps = at_once;
    for (int k = 1; k <= 50; ++k) in_steps.to(frame, start + (beyond - start) * k / 50);
    const Vec3 by = at_once.to(frame, beyond).by;
    CHECK((by - in_steps.motion().by).norm() < 1e-9);
    CHECK(by.z() < -10);
    CHECK(frame.project(by));
  }
}

}  // namespace
}  // namespace croquis
