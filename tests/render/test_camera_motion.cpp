// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/render/camera_motion.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::render;

namespace {

const glm::dvec2 view_size(800, 500);

/// Cameras as views have them: parallel from the front and the side, perspective from anywhere, at several scales.
std::vector<Camera> usual_cameras() {
  std::vector<Camera> cameras;
  for (const double scale : {1e-3, 1.0, 1e4}) {
    const Bounds box{glm::dvec3(-1, 0, -2) * scale, glm::dvec3(3, 2, 1) * scale};
    for (const NamedView view : {NamedView::Front, NamedView::Side, NamedView::Top, NamedView::Perspective}) {
      cameras.push_back(frame(box, view_direction(view), view_size.x / view_size.y));
    }
    cameras.push_back(frame(box, {{0.3, 0.7, 0.2}, {0, 1, 0}, Projection::Perspective}, 1.6));
  }
  return cameras;
}

double size_of(const Camera& camera) { return glm::distance(camera.eye, camera.target); }

/// A point before the eye, some way beside the target.
glm::dvec3 point_near_target(const Camera& camera) {
  return camera.target + 0.1 * size_of(camera) * glm::dvec3(0.4, -0.7, 0.5);
}

glm::dvec3 up_on_screen(const Camera& camera) {
  const glm::dmat4 view = view_matrix(camera);
  return {view[0][1], view[1][1], view[2][1]};
}

glm::dvec3 right_on_screen(const Camera& camera) {
  const glm::dmat4 view = view_matrix(camera);
  return {view[0][0], view[1][0], view[2][0]};
}

void check_close(const glm::dvec2& a, const glm::dvec2& b) { CHECK(glm::distance(a, b) < 1e-6); }

}  // namespace

TEST_CASE("a pixel's place at the target's distance is found again under the pixel") {
  for (const Camera& camera : usual_cameras()) {
    for (const glm::dvec2& pixel : {glm::dvec2(0, 0), glm::dvec2(400, 250), glm::dvec2(123.25, 456.5)}) {
      const auto again = project(camera, point_at_target(camera, pixel, view_size), view_size);
      REQUIRE(again);
      CHECK(glm::distance(*again, pixel) < 1e-9 * view_size.x);
    }
  }
}

TEST_CASE("what is behind the eye is under no pixel") {
  Camera away;
  away.projection = Projection::Perspective;
  away.eye = {0, 0, 2};
  away.target = {0, 0, 5};
  CHECK_FALSE(project(away, {0, 0, 1}, view_size));
  CHECK(project(away, {0, 0, 3}, view_size));
}

TEST_CASE("tumbling keeps the pivot on its pixel and at its distance") {
  for (const Camera& camera : usual_cameras()) {
    const glm::dvec3 pivot = point_near_target(camera);
    for (const glm::dvec2& turn : {glm::dvec2(0.3, 0.2), glm::dvec2(-2, -0.4), glm::dvec2(0, 3)}) {
      const Camera moved = tumble(camera, pivot, turn);
      check_close(*project(moved, pivot, view_size), *project(camera, pivot, view_size));
      CHECK(glm::distance(moved.eye, pivot) == Approx(glm::distance(camera.eye, pivot)));
      CHECK(size_of(moved) == Approx(size_of(camera)));
    }
  }
}

TEST_CASE("whatever the way, a turntable keeps the horizon level and the model's top up") {
  test::Random random(7);
  for (Camera camera : usual_cameras()) {
    const glm::dvec3 pivot = camera.target;
    for (int step = 0; step < 200; ++step) {
      camera = tumble(camera, pivot, {random.between(-0.5, 0.5), random.between(-0.5, 0.5)});
      REQUIRE(std::abs(right_on_screen(camera).y) < 1e-9);
      REQUIRE(up_on_screen(camera).y > -1e-9);
    }
  }
}

TEST_CASE("at the poles tumbling stops rising and still turns, without a jump") {
  Camera camera = usual_cameras().front();
  const glm::dvec3 pivot = camera.target;
  for (int i = 0; i < 40; ++i) camera = tumble(camera, pivot, {0, 0.1});
  CHECK(glm::normalize(camera.eye - camera.target).y == Approx(1).epsilon(1e-12));
  const Camera stuck = tumble(camera, pivot, {0, 0.1});
  CHECK(glm::distance(up_on_screen(stuck), up_on_screen(camera)) < 1e-9);
  const Camera turned = tumble(camera, pivot, {0.01, 0});
  CHECK(glm::distance(up_on_screen(turned), up_on_screen(camera)) == Approx(0.01).epsilon(1e-3));
  // The way down again is the way up backwards.
  const Camera back = tumble(camera, pivot, {0, -0.05});
  CHECK(glm::distance(up_on_screen(back), up_on_screen(camera)) == Approx(0.05).epsilon(1e-3));
}

TEST_CASE("the model follows the hand: right turns it right, down tips its top towards the eye") {
  for (const Camera& camera : usual_cameras()) {
    const glm::dvec3 to_eye = camera.eye - camera.target;
    if (std::abs(to_eye.y) > 0.9 * glm::length(to_eye)) continue;
    const glm::dvec3 near_point = camera.target + 0.1 * to_eye;
    const glm::dvec2 before = *project(camera, near_point, view_size);
    CHECK(project(tumble(camera, camera.target, {0.1, 0}), near_point, view_size)->x > before.x);
    CHECK(project(tumble(camera, camera.target, {0, 0.1}), near_point, view_size)->y > before.y);
    CHECK(tumble(camera, camera.target, {0, 0.1}).eye.y > camera.eye.y);
  }
}

TEST_CASE("tracking moves what is at the target's distance with the pointer") {
  for (const Camera& camera : usual_cameras()) {
    const glm::dvec2 start(310, 120), way(37, -55);
    const glm::dvec3 held = point_at_target(camera, start, view_size);
    check_close(*project(track(camera, way, view_size.y), held, view_size), start + way);
  }
}

TEST_CASE("dollying makes things larger by the factor and keeps the target in the middle") {
  for (const Camera& camera : usual_cameras()) {
    const Camera nearer = dolly(camera, 2);
    check_close(*project(nearer, camera.target, view_size), 0.5 * view_size);
    const double before = units_per_pixel(camera, camera.target, view_size.y);
    CHECK(units_per_pixel(nearer, camera.target, view_size.y) == Approx(before / 2));
    CHECK(units_per_pixel(dolly(nearer, 0.5), camera.target, view_size.y) == Approx(before));
  }
}

TEST_CASE("dollying about a pixel keeps what is under it") {
  for (const Camera& camera : usual_cameras()) {
    const glm::dvec2 pixel(655, 81);
    const glm::dvec3 held = point_at_target(camera, pixel, view_size);
    for (const double factor : {0.2, 0.9, 1.3, 40.0}) {
      check_close(*project(dolly_about(camera, factor, pixel, view_size), held, view_size), pixel);
      const glm::dvec3 anchor = point_near_target(camera);
      check_close(*project(dolly_about(camera, factor, anchor), anchor, view_size),
                  *project(camera, anchor, view_size));
    }
  }
}

TEST_CASE("factors that make no sense leave the camera as it is") {
  const Camera camera = usual_cameras().back();
  for (const double factor : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    CHECK(dolly(camera, factor).eye == camera.eye);
    CHECK(dolly_about(camera, factor, camera.target).height == camera.height);
  }
}

TEST_CASE("a pixel spans as many model units as two neighbours are apart") {
  for (const Camera& camera : usual_cameras()) {
    const glm::dvec3 a = point_at_target(camera, {400, 250}, view_size);
    const glm::dvec3 b = point_at_target(camera, {401, 250}, view_size);
    CHECK(units_per_pixel(camera, a, view_size.y) == Approx(glm::distance(a, b)));
  }
}
