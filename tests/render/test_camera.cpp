// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/render/camera.h"

using namespace croquis::render;

namespace {

/// Where a model point lands: x right and y up in [-1, 1], z the depth.
glm::dvec3 project(const Camera& camera, double aspect, const Bounds& bounds, const glm::dvec3& point) {
  const glm::dmat4 matrix = projection_matrix(camera, aspect, depth_range(camera, bounds)) * view_matrix(camera);
  const glm::dvec4 clip = matrix * glm::dvec4(point, 1);
  return glm::dvec3(clip) / clip.w;
}

constexpr NamedView all_views[] = {NamedView::Front, NamedView::Side, NamedView::Top, NamedView::Perspective};

}  // namespace

TEST_CASE("framing shows the whole box in every view and fills one direction") {
  const NamedView view = GENERATE(from_range(std::begin(all_views), std::end(all_views)));
  const double aspect = GENERATE(0.4, 1.0, 2.5);
  const double size = GENERATE(1e-9, 1.0, 1e9);
  const Bounds bounds{glm::dvec3(-1, 2, 3) * size, glm::dvec3(4, 2.5, 5) * size};
  const double margin = 0.06;
  const Camera camera = frame(bounds, view_direction(view), aspect, margin);
  double reach = 0;
  for (const glm::dvec3& corner : bounds.corners()) {
    const glm::dvec3 place = project(camera, aspect, bounds, corner);
    reach = std::max({reach, std::abs(place.x), std::abs(place.y)});
    CHECK(std::abs(place.z) <= 1);
  }
  CHECK(reach == Approx(1 - 2 * margin).epsilon(1e-6));
}

TEST_CASE("points are framed as tightly as the picture allows, in its middle") {
  const NamedView view = GENERATE(from_range(std::begin(all_views), std::end(all_views)));
  const std::vector<glm::dvec3> points = {{0, 0, 0}, {5, 1, 0}, {1, 4, 2}, {2, 2, 7}};
  Bounds bounds;
  for (const glm::dvec3& point : points) bounds.add(point);
  const Camera camera = frame(points, view_direction(view), 1.25, 0.1);
  Bounds seen;
  for (const glm::dvec3& point : points) seen.add(project(camera, 1.25, bounds, point));
  CHECK(std::max(seen.max.x, seen.max.y) == Approx(0.8).epsilon(0.005));
  CHECK(std::abs(seen.max.x + seen.min.x) < 0.005);
  CHECK(std::abs(seen.max.y + seen.min.y) < 0.005);
}

TEST_CASE("named views put the axes where people expect them") {
  const Bounds bounds{glm::dvec3(-1), glm::dvec3(1)};
  const auto direction_on_screen = [&](NamedView view, const glm::dvec3& axis) {
    const Camera camera = frame(bounds, view_direction(view), 1);
    return project(camera, 1, bounds, axis) - project(camera, 1, bounds, glm::dvec3(0));
  };
  const auto points = [](const glm::dvec3& screen, const glm::dvec2& expected) {
    return glm::length(glm::normalize(glm::dvec2(screen)) - expected) < 1e-9;
  };
  CHECK(points(direction_on_screen(NamedView::Front, {1, 0, 0}), {1, 0}));
  CHECK(points(direction_on_screen(NamedView::Front, {0, 1, 0}), {0, 1}));
  CHECK(direction_on_screen(NamedView::Front, {0, 0, 1}).z < 0);
  CHECK(points(direction_on_screen(NamedView::Side, {0, 0, -1}), {1, 0}));
  CHECK(points(direction_on_screen(NamedView::Side, {0, 1, 0}), {0, 1}));
  CHECK(direction_on_screen(NamedView::Side, {1, 0, 0}).z < 0);
  CHECK(points(direction_on_screen(NamedView::Top, {1, 0, 0}), {1, 0}));
  CHECK(points(direction_on_screen(NamedView::Top, {0, 0, -1}), {0, 1}));
  CHECK(direction_on_screen(NamedView::Top, {0, 1, 0}).z < 0);
  // In the three-quarter view x, y and z all come towards the eye.
  CHECK(direction_on_screen(NamedView::Perspective, {1, 0, 0}).x > 0);
  CHECK(direction_on_screen(NamedView::Perspective, {0, 1, 0}).y > 0);
  CHECK(direction_on_screen(NamedView::Perspective, {0, 0, 1}).x < 0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0);
    step[axis] = 1;
    CHECK(direction_on_screen(NamedView::Perspective, step).z < 0);
  }
}

TEST_CASE("nothing and a single point can be framed, too") {
  Bounds point;
  const bool single = GENERATE(false, true);
  if (single) point.add({1e5, -3, 7});
  for (const NamedView view : all_views) {
    const Camera camera = frame(point, view_direction(view), 1.5);
    const glm::dvec3 expected = single ? glm::dvec3(1e5, -3, 7) : glm::dvec3(0);
    CHECK(glm::length(project(camera, 1.5, point, expected)) < 2);
    CHECK(glm::distance(camera.eye, camera.target) > 0);
    CHECK(camera.height > 0);
  }
}

TEST_CASE("an up vector along the line of sight is replaced by one that works") {
  const Bounds bounds{glm::dvec3(-1), glm::dvec3(1)};
  const Camera camera = frame(bounds, {{0, -2, 0}, {0, 5, 0}, Projection::Orthographic}, 1);
  for (const glm::dvec3& corner : bounds.corners()) {
    CHECK(glm::length(glm::dvec2(project(camera, 1, bounds, corner))) == Approx(std::sqrt(2.0) * 0.88));
  }
}

TEST_CASE("the line of sight meets the picture at the principal point, and all else moves with it") {
  const Bounds bounds{glm::dvec3(-1), glm::dvec3(1)};
  const double aspect = 1.6;
  Camera camera = frame(bounds, view_direction(NamedView::Perspective), aspect);
  const glm::dvec3 points[] = {camera.target, {0.4, -0.3, 0.2}, {-1, 1, 1}};
  std::vector<glm::dvec3> centred;
  for (const glm::dvec3& point : points) centred.push_back(project(camera, aspect, bounds, point));
  CHECK(glm::length(glm::dvec2(centred[0])) < 1e-12);
  camera.principal_offset = {0.15, -0.25};
  for (std::size_t i = 0; i < centred.size(); ++i) {
    const glm::dvec3 moved = project(camera, aspect, bounds, points[i]) - centred[i];
    // The picture is two units wide and two high; the offset is in its heights.
    CHECK(moved.x == Approx(2 * 0.15 / aspect));
    CHECK(moved.y == Approx(2 * -0.25));
    CHECK(moved.z == Approx(0).margin(1e-12));
  }
}
