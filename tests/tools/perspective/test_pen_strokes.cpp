// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <catch2/catch.hpp>

#include "croquis/tools/perspective/axis_guess.h"
#include "croquis/tools/perspective/drawing_edit.h"
#include "croquis/tools/perspective/pen_strokes.h"
#include "tools/perspective/perspective_ink.h"

namespace croquis {
namespace {

using test::hand_drawn;
using test::plain_drawing;
using test::truth_of;

PerspectiveDrawing empty_sheet() {
  PerspectiveDrawing drawing;
  drawing.image_size = {1000, 750};
  return drawing;
}

test::View usual_view() { return test::three_point_views()[1]; }

/// Largest distance of places on one chain to another one.
double deviation(const std::vector<PictureCubic>& made, bool straight, const std::vector<PictureCubic>& truth) {
  double largest = 0;
  for (const Vec2& place : traced(made, straight, 48)) {
    double nearest = 1e300;
    for (const Vec2& other : traced(truth, false, 400)) nearest = std::min(nearest, (place - other).norm());
    largest = std::max(largest, nearest);
  }
  return largest;
}

TEST_CASE("lines of a hand become lines, curves become few pieces, both near what was meant") {
  test::Random random(3);
  int curves = 0, pieces = 0;
  for (const test::PerspectiveSolid& solid : {test::box(), test::bottle(), test::camera_body(), test::soap()}) {
    const test::SolidDrawing truth = plain_drawing(solid, usual_view());
    for (const PerspectiveStroke& stroke : truth.drawing.strokes) {
      if (stroke.role != StrokeRole::Edge) continue;
      const double size = (stroke.end() - stroke.start()).norm();
      if (size < 40) continue;
      INFO(solid.name << " " << stroke.id);
      const std::vector<StrokeShape> shapes = shapes_of(hand_drawn(stroke.pieces, random, 0.005 * size));
      REQUIRE(shapes.size() == 1);
      CHECK(deviation(shapes[0].pieces, shapes[0].straight, stroke.pieces) < 0.02 * size + 3);
      if (stroke.straight) CHECK(shapes[0].straight);
      if (shapes[0].straight) continue;
      ++curves;
      pieces += static_cast<int>(shapes[0].pieces.size());
    }
  }
  REQUIRE(curves > 8);
  CHECK(pieces <= curves * 3 / 2);
}

TEST_CASE("a gesture with corners becomes one stroke for each side, and they meet") {
  std::vector<Vec2> path;
  const std::vector<Vec2> corners = {{100, 100}, {400, 130}, {420, 400}, {120, 380}, {101, 102}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    for (int k = 0; k < 60; ++k) path.push_back(corners[i] + (corners[i + 1] - corners[i]) * k / 60.0);
  }
  path.push_back(corners.back());
  const std::vector<StrokeShape> shapes = shapes_of(path);
  REQUIRE(shapes.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(shapes[i].straight);
    CHECK(shapes[i].end() == shapes[(i + 1) % 4].start());
    double nearest = 1e300;
    for (const Vec2& corner : corners) nearest = std::min(nearest, (corner - shapes[i].start()).norm());
    CHECK(nearest < 6);
  }
}

TEST_CASE("a loop without corners becomes four curves that go on into each other") {
  std::vector<Vec2> path;
  for (int k = 0; k <= 200; ++k) {
    const double angle = 2 * std::numbers::pi * k / 200 * 0.995;
    path.emplace_back(500 + 150 * std::cos(angle), 300 + 90 * std::sin(angle));
  }
  const std::vector<StrokeShape> shapes = shapes_of(path);
  REQUIRE(shapes.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const StrokeShape& next = shapes[(i + 1) % 4];
    CHECK(!shapes[i].straight);
    CHECK(shapes[i].end() == next.start());
    const Vec2 before = shapes[i].pieces.back()[3] - shapes[i].pieces.back()[2];
    const Vec2 after = next.pieces.front()[1] - next.pieces.front()[0];
    CHECK(std::atan2(std::abs(cross(before, after)), before.dot(after)) < 0.03);
    for (const Vec2& place : traced(shapes[i].pieces, false)) {
      const Vec2 unit((place.x() - 500) / 150, (place.y() - 300) / 90);
      CHECK(std::abs(unit.norm() - 1) < 0.02);
    }
  }
}

TEST_CASE("a tap and a gesture without extent are no strokes") {
  CHECK(shapes_of(std::vector<Vec2>{}).empty());
  CHECK(shapes_of(std::vector<Vec2>{{3, 3}}).empty());
  CHECK(shapes_of(std::vector<Vec2>{{3, 3}, {4, 3}, {3, 4}, {3, 3}}).empty());
}

TEST_CASE("with the camera known, lines of a hand find their axis") {
  int right = 0, wrong = 0, unknown = 0;
  for (const test::PerspectiveSolid& solid : {test::box(), test::l_block(), test::camera_body()}) {
    for (const test::View& view : test::three_point_views()) {
      const test::SolidDrawing truth = plain_drawing(solid, view);
      const SolvedDrawing solved = truth_of(truth);
      test::Random random(11);
      for (const PerspectiveStroke& stroke : truth.drawing.strokes) {
        if (!is_parallel(stroke.group) || (stroke.end() - stroke.start()).norm() < 60) continue;
        const std::vector<Vec2> ink = hand_drawn(stroke.pieces, random, 2);
        PerspectiveDrawing drawing = empty_sheet();
        PenStrokeOptions options;
        options.solved = &solved;
        const auto ids = draw_strokes(drawing, ink, options);
        REQUIRE(ids.size() == 1);
        const StrokeGroup group = drawing.strokes.back().group;
        (group == stroke.group ? right : group == StrokeGroup::Unknown ? unknown : wrong) += 1;
      }
    }
  }
  INFO(right << " right, " << wrong << " wrong, " << unknown << " unknown");
  CHECK(wrong * 100 < right);
  CHECK(unknown * 50 < right);
}

TEST_CASE("before there is a camera, the first lines of a box seen from a corner find their axes") {
  int right = 0, all = 0;
  for (const test::View& view : test::three_point_views()) {
    const test::SolidDrawing truth = plain_drawing(test::box(), view);
    PerspectiveDrawing drawing = empty_sheet();
    test::Random random(5);
    std::map<StrokeGroup, StrokeGroup> named;  // what the first line of each true axis was called
    for (const PerspectiveStroke& stroke : truth.drawing.strokes) {
      if (stroke.role != StrokeRole::Edge) continue;
      draw_strokes(drawing, hand_drawn(stroke.pieces, random, 2), {});
      const StrokeGroup made = drawing.strokes.back().group;
      const StrokeGroup wanted = named.emplace(stroke.group, made).first->second;
      ++all;
      right += made == wanted;
    }
    CHECK(named.size() == 3);
    CHECK(named[StrokeGroup::ParallelZ] == StrokeGroup::ParallelZ);
  }
  INFO(right << " of " << all << " lines agree with the first one of their axis");
  CHECK(right * 10 >= all * 8);
}

TEST_CASE("vanishing points of a few lines are where they meet, and directions where there is one line") {
  PerspectiveDrawing drawing = empty_sheet();
  for (const double y : {100.0, 300.0, 500.0}) {
    const Vec2 from(100, y);
    const Vec2 meeting(2000, 250);
    add_stroke(drawing, {{line_piece(from, from + 0.2 * (meeting - from))}, true}, StrokeGroup::ParallelX,
               StrokeRole::Construction);
  }
  add_stroke(drawing, {{line_piece({200, 100}, {210, 500})}, true}, StrokeGroup::ParallelZ, StrokeRole::Edge);
  const auto points = seen_vanishing_points(drawing, nullptr);
  REQUIRE(points[0]);
  CHECK((points[0]->head<2>() / points[0]->z() - Vec2(2000, 250)).norm() < 1e-6);
  CHECK(!points[1]);
  REQUIRE(points[2]);
  CHECK(points[2]->z() == 0);
  CHECK(angle_to(*points[2], {700, 600}, {-10, -400}) < 1e-12);
}

TEST_CASE("ends near a vertex go to it with its name, and never both to the same one") {
  PerspectiveDrawing drawing = empty_sheet();
  add_stroke(drawing, {{line_piece({100, 100}, {300, 120})}, true}, StrokeGroup::ParallelX, StrokeRole::Edge);
  drawing.strokes.back().to = "b";
  std::vector<Vec2> ink;
  for (int k = 0; k <= 50; ++k) ink.push_back(Vec2(308, 128) + k / 50.0 * Vec2(4, 200));
  draw_strokes(drawing, ink, {});
  CHECK(drawing.strokes[1].start() == Vec2(300, 120));
  CHECK(drawing.strokes[1].from == "b");
  CHECK(drawing.strokes[1].to.empty());

  std::vector<Vec2> tick;
  for (int k = 0; k <= 20; ++k) tick.push_back(Vec2(295, 116) + k / 20.0 * Vec2(14, 6));
  draw_strokes(drawing, tick, {});
  for (const PerspectiveStroke& stroke : drawing.strokes) CHECK(stroke.start() != stroke.end());

  PenStrokeOptions construction;
  construction.role = StrokeRole::Construction;
  draw_strokes(drawing, ink, construction);
  CHECK(drawing.strokes.back().start() != Vec2(300, 120));
}

TEST_CASE("what joins two known vertices lies in the plane that both are in") {
  const test::SolidDrawing truth = plain_drawing(test::bottle(), usual_view());
  const SolvedDrawing solved = truth_of(truth);
  int planes = 0;
  for (std::size_t i = 0; i < truth.network.curves.size(); ++i) {
    const NetworkCurve& curve = truth.network.curves[i];
    if (is_parallel(truth.groups[i])) continue;
    const Vec2 from = truth.camera.project(truth.network.vertices[curve.start]);
    const Vec2 to = truth.camera.project(truth.network.vertices[curve.end]);
    const StrokeShape chord{{line_piece(from, to)}, true};
    CHECK(guess_plane(empty_sheet(), &solved, chord, 3, truth.groups[i]) == truth.groups[i]);
    const Vec3 step = truth.network.vertices[curve.end] - truth.network.vertices[curve.start];
    if ((step.array().abs() < 1e-9).count() == 1) {
      ++planes;
      CHECK(guess_plane(empty_sheet(), &solved, chord, 3, StrokeGroup::Unknown) == truth.groups[i]);
    }
  }
  CHECK(planes > 0);
}

TEST_CASE("an arc between an upright and a level line lies in the plane of both, whatever its ends are moved by") {
  const test::SolidDrawing truth = plain_drawing(test::box(), usual_view());
  SolvedDrawing solved = truth_of(truth);
  solved.network = {};
  const auto seen = [&](double y, double z) { return truth.camera.project({0.5, y, z}); };
  PerspectiveDrawing drawing = empty_sheet();
  add_stroke(drawing, {{line_piece(seen(0, 0), seen(0, 1))}, true}, StrokeGroup::ParallelZ, StrokeRole::Edge);
  add_stroke(drawing, {{line_piece(seen(0.8, 1.8), seen(2, 1.8))}, true}, StrokeGroup::ParallelY, StrokeRole::Edge);
  test::Random random(3);
  PenStrokeOptions options;
  options.solved = &solved;
  // The lines are two pieces, each of a scale of its own: places in space are known, but share no coordinate.
  const Vec3 eye = truth.camera.eye;
  solved.network.vertices = {{0.5, 0, 0}, {0.5, 0, 1}};
  for (const Vec3& other : {Vec3(0.5, 0.8, 1.8), Vec3(0.5, 2, 1.8)})
    solved.network.vertices.push_back(eye + 1.2 * (other - eye));
  for (int trial = 0; trial < 12; ++trial) {
    std::vector<Vec2> arc;
    const Vec2 off(random.between(-6, 6), random.between(-6, 6));
    for (int k = 0; k <= 40; ++k) {
      const double angle = std::numbers::pi / 2 * k / 40;
      arc.push_back(seen(0.8 - 0.8 * std::cos(angle), 1 + 0.8 * std::sin(angle)) + off);
    }
    PerspectiveDrawing drawn = drawing;
    REQUIRE(draw_strokes(drawn, arc, options).size() == 1);
    CHECK(drawn.strokes.back().group == StrokeGroup::NormalX);
  }
}

/// Samples of a mouse: whole pixels, dense where the hand starts and stops.
std::vector<Vec2> mouse_way(const std::vector<Vec2>& line, test::Random& random, double tremor) {
  std::vector<Vec2> places;
  for (int k = 0; k <= 40; ++k) {
    const double t = k / 40.0, eased = t * t * (3 - 2 * t) * static_cast<double>(line.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(eased), line.size() - 2);
    Vec2 place = line[i] + (eased - static_cast<double>(i)) * (line[i + 1] - line[i]);
    place += Vec2(random.between(-tremor, tremor), random.between(-tremor, tremor));
    places.emplace_back(std::round(place.x()), std::round(place.y()));
  }
  return places;
}

TEST_CASE("small arcs of a mouse are one curve each, small corners stay corners") {
  test::Random random(21);
  for (const double radius : {28.0, 35.0, 60.0, 90.0}) {
    for (const double squash : {0.4, 0.6, 1.0}) {
      for (const double turned : {0.3, 1.1, 2.4, 4.0}) {
        std::vector<Vec2> line;
        for (int k = 0; k <= 60; ++k) {
          const double angle = std::numbers::pi / 2 * k / 60;
          const Vec2 flat(radius * std::cos(angle), squash * radius * std::sin(angle));
          line.emplace_back(200 + std::cos(turned) * flat.x() - std::sin(turned) * flat.y(),
                            200 + std::sin(turned) * flat.x() + std::cos(turned) * flat.y());
        }
        INFO("radius " << radius << " squash " << squash << " turned " << turned);
        CHECK(shapes_of(mouse_way(line, random, 0.4)).size() == 1);
      }
    }
  }
  for (const double size : {25.0, 40.0, 90.0}) {
    const std::vector<Vec2> corner = {{100, 100}, {100 + size, 100 + size / 8}, {100 + size, 100 + size}};
    CHECK(shapes_of(mouse_way(corner, random, 0.4)).size() == 2);
  }
}

TEST_CASE("a hook where the pen went down isn't a stroke of its own") {
  test::Random random(2);
  for (const double hook : {4.0, 7.0, 10.0}) {
    const std::vector<Vec2> way = {{100 - hook, 100 + hook / 3}, {100, 100}, {110, 190}, {130, 260}};
    std::vector<Vec2> line;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) {
      for (int k = 0; k < 30; ++k) line.push_back(way[i] + k / 30.0 * (way[i + 1] - way[i]));
    }
    line.push_back(way.back());
    INFO("hook of " << hook << " pixels");
    CHECK(shapes_of(line).size() == 1);
  }
}

TEST_CASE("a curve that rounds a corner lies in the plane of the axes at its ends, before it is tied to anything") {
  int right = 0, wrong = 0, all = 0;
  test::Random random(8);
  for (const test::View& view : test::three_point_views()) {
    const test::SolidDrawing truth = plain_drawing(test::box(), view);
    SolvedDrawing solved = truth_of(truth);
    const std::vector<Vec3> corners = std::exchange(solved.network, {}).vertices;  // nothing to be tied to
    const double radius = 0.3 * (corners[0] - corners[1]).norm();
    for (const Vec3& corner : corners) {
      for (int normal = 0; normal < 3; ++normal) {
        std::vector<Vec2> line;
        for (int k = 0; k <= 60; ++k) {
          const double angle = std::numbers::pi / 2 * k / 60;
          Vec3 place = corner;
          place[(normal + 1) % 3] += radius * std::cos(angle);
          place[(normal + 2) % 3] += radius * std::sin(angle);
          line.push_back(truth.camera.project(place));
        }
        PerspectiveDrawing drawing = empty_sheet();
        PenStrokeOptions options;
        options.solved = &solved;
        if ((line.front() - line.back()).norm() < 50) continue;
        if (draw_strokes(drawing, mouse_way(line, random, 0.4), options).size() != 1) continue;
        if (drawing.strokes.back().straight) continue;
        ++all;
        right += drawing.strokes.back().group == static_cast<StrokeGroup>(3 + normal);
        wrong += drawing.strokes.back().group != static_cast<StrokeGroup>(3 + normal) &&
                 drawing.strokes.back().group != StrokeGroup::Unknown;
      }
    }
  }
  INFO(right << " right, " << wrong << " wrong of " << all);
  REQUIRE(all > 30);
  CHECK(wrong * 20 <= all);
  CHECK(right * 10 >= all * 8);
}

}  // namespace
}  // namespace croquis
