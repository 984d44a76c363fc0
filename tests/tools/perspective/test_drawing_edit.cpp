// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/tools/perspective/drawing_edit.h"
#include "tools/perspective/perspective_ink.h"

namespace croquis {
namespace {

using test::plain_drawing;

PerspectiveDrawing box_drawing() { return plain_drawing(test::box(), test::three_point_views()[1]).drawing; }

std::size_t edges_of(const PerspectiveDrawing& drawing) {
  std::size_t count = 0;
  for (const PerspectiveStroke& stroke : drawing.strokes) count += stroke.role == StrokeRole::Edge;
  return count;
}

const PerspectiveStroke& first_edge(const PerspectiveDrawing& drawing) {
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (stroke.role == StrokeRole::Edge) return stroke;
  }
  return drawing.strokes.front();
}

TEST_CASE("a box has eight vertices where three edges end, before and after an end was dragged") {
  PerspectiveDrawing drawing = box_drawing();
  REQUIRE(edges_of(drawing) == 12);
  CHECK(vertices_of(drawing).size() == 8);
  const std::string id = first_edge(drawing).id;
  const Vec2 before = first_edge(drawing).start();
  move_point(drawing, id, 0, {31, -12});
  CHECK(vertices_of(drawing).size() == 8);
  std::size_t moved = 0;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    for (const Vec2& end : {stroke.start(), stroke.end()}) moved += (end - before - Vec2(31, -12)).norm() < 1e-9;
  }
  CHECK(moved == 3);
  move_point(drawing, id, 0, {40, 0}, true);
  CHECK(vertices_of(drawing).size() == 9);
}

TEST_CASE("an end dragged back onto its vertex joins it again") {
  PerspectiveDrawing drawing = box_drawing();
  const std::string id = first_edge(drawing).id;
  const Vec2 home = first_edge(drawing).start();
  drag_point(drawing, id, 0, {60, 25}, true);
  REQUIRE(vertices_of(drawing).size() == 9);
  drag_point(drawing, id, 0, home - find_stroke(drawing, id)->start(), false);
  CHECK(vertices_of(drawing).size() == 8);
  CHECK((find_stroke(drawing, id)->start() - home).norm() < 1e-9);
}

TEST_CASE("a stroke that is moved takes the vertices at its ends along") {
  PerspectiveDrawing drawing = box_drawing();
  const std::string id = first_edge(drawing).id;
  move_strokes(drawing, {id}, {17, 9});
  CHECK(vertices_of(drawing).size() == 8);
  const PerspectiveDrawing moved = drawing;
  move_strokes(drawing, {id}, {-17, -9});
  const PerspectiveDrawing original = box_drawing();
  for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
    CHECK((drawing.strokes[i].start() - original.strokes[i].start()).norm() < 1e-9);
    CHECK((drawing.strokes[i].end() - original.strokes[i].end()).norm() < 1e-9);
  }
}

TEST_CASE("dragging a handle at a smooth joint turns the other one and leaves the ends") {
  PerspectiveDrawing drawing;
  drawing.image_size = {1000, 750};
  StrokeShape shape{{{Vec2(0, 0), Vec2(30, 60), Vec2(70, 100), Vec2(100, 100)},
                     {Vec2(100, 100), Vec2(140, 100), Vec2(180, 60), Vec2(200, 0)}},
                    false};
  const std::string id = add_stroke(drawing, shape, StrokeGroup::NormalY, StrokeRole::Edge);
  REQUIRE(points_of(drawing.strokes[0]).size() == 7);
  move_point(drawing, id, 4, {-40, 40});  // straight below the joint
  const auto& pieces = drawing.strokes[0].pieces;
  CHECK((pieces[0][2] - Vec2(100, 70)).norm() < 1e-9);
  CHECK(pieces[0][0] == Vec2(0, 0));
  CHECK(pieces[1][3] == Vec2(200, 0));
  move_point(drawing, id, 3, {5, 5});
  CHECK(pieces[0][3] == Vec2(105, 105));
  CHECK(pieces[1][0] == Vec2(105, 105));
  CHECK(pieces[1][1] == Vec2(105, 145));
}

TEST_CASE("strokes and points that aren't there are refused by name") {
  PerspectiveDrawing drawing = box_drawing();
  CHECK_THROWS_AS(move_point(drawing, "nobody", 0, {1, 1}), Error);
  CHECK_THROWS_AS(move_point(drawing, first_edge(drawing).id, 2, {1, 1}), Error);
  CHECK_THROWS_AS(set_length(drawing, "nobody", 3.0), Error);
  CHECK_THROWS_AS(set_length(drawing, first_edge(drawing).id, 0.0), Error);
  CHECK_THROWS_AS(set_strokes(drawing, {"nobody"}, {StrokeGroup::ParallelX, {}, {}}), Error);
}

TEST_CASE("deleting a stroke forgets its length, and new ids are never those of others") {
  PerspectiveDrawing drawing = box_drawing();
  const std::string id = first_edge(drawing).id;
  set_length(drawing, id, 4.0);
  set_length(drawing, id, 5.0);
  REQUIRE(drawing.known_lengths.size() == 1);
  CHECK(drawing.known_lengths[0].length == 5);
  CHECK(remove_strokes(drawing, {id, "nobody"}));
  CHECK(drawing.known_lengths.empty());
  CHECK(!remove_strokes(drawing, {id}));
  std::set<std::string> ids;
  for (const PerspectiveStroke& stroke : drawing.strokes) ids.insert(stroke.id);
  for (int k = 0; k < 5; ++k) {
    const Vec2 from(10 * k, 0);
    ids.insert(
        add_stroke(drawing, {{line_piece(from, from + Vec2(50, 3))}, true}, StrokeGroup::ParallelX, StrokeRole::Edge));
  }
  CHECK(ids.size() == drawing.strokes.size());
}

TEST_CASE("a curve that is to be parallel to an axis becomes the line between its ends") {
  PerspectiveDrawing drawing = plain_drawing(test::bottle(), test::three_point_views()[1]).drawing;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (stroke.straight) continue;
    const Vec2 from = stroke.start(), to = stroke.end();
    StrokeSetting setting;
    setting.group = StrokeGroup::ParallelZ;
    const std::string id = stroke.id;
    set_strokes(drawing, {id}, setting);
    const PerspectiveStroke& changed = *find_stroke(drawing, id);
    CHECK(changed.straight);
    CHECK(changed.start() == from);
    CHECK(changed.end() == to);
    return;
  }
  FAIL("the bottle has no curve");
}

TEST_CASE("lines that are aimed meet in that place and keep middle and length") {
  PerspectiveDrawing drawing = box_drawing();
  const PerspectiveDrawing before = drawing;
  const Vec2 target(1800, 240);
  REQUIRE(aim_lines(drawing, 0, target));
  int aimed = 0;
  for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
    const PerspectiveStroke& now = drawing.strokes[i];
    const PerspectiveStroke& old = before.strokes[i];
    if (now.role != StrokeRole::Construction || now.group != StrokeGroup::ParallelX) {
      CHECK(now.start() == old.start());
      continue;
    }
    ++aimed;
    const Vec2 way = now.end() - now.start();
    CHECK(std::abs(cross(way.normalized(), target - now.start())) < 1e-6);
    CHECK(way.norm() == Approx((old.end() - old.start()).norm()));
    CHECK((now.start() + now.end() - old.start() - old.end()).norm() < 1e-6);
  }
  CHECK(aimed == 3);
}

TEST_CASE("strokes, points and faces are picked where they are seen") {
  const test::SolidDrawing truth = plain_drawing(test::bottle(), test::three_point_views()[1]);
  const PerspectiveDrawing& drawing = truth.drawing;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (stroke.role != StrokeRole::Edge) continue;
    const Vec2 on = place_on(stroke.pieces.front(), 0.37);
    CHECK(nearest_stroke(drawing, on, 3));
    const auto point = nearest_point(drawing, {stroke.id}, stroke.end() + Vec2(2, 1), 5);
    REQUIRE(point);
    CHECK(point->point + 1 == points_of(stroke).size());
  }
  CHECK(!nearest_stroke(drawing, {-500, -500}, 10));
  const PickBox all = PickBox::spanned({-4000, -4000}, {5000, 5000});
  CHECK(strokes_in_box(drawing, all).size() == drawing.strokes.size());
}

TEST_CASE("a place lies within the face whose strokes go around it") {
  const test::PerspectiveSolid solid = test::soap();
  const test::SolidDrawing truth = plain_drawing(solid, test::three_point_views()[1]);
  const PerspectiveDrawing& drawing = truth.drawing;
  for (const auto& face : solid.faces) {
    std::vector<std::string> ids;
    Vec2 middle = Vec2::Zero();
    for (const auto& side : face.loops.front()) {
      ids.push_back(truth.network.curves[side.curve].id);
      middle += truth.camera.project(truth.network.curves[side.curve].pieces.front().at(0.5));
    }
    middle /= static_cast<double>(ids.size());
    CHECK(face_at(drawing, {ids}, middle));
    CHECK(!face_at(drawing, {ids}, middle + Vec2(3000, 0)));
    std::rotate(ids.begin(), ids.begin() + 1, ids.end());
    std::swap(ids[0], ids[1]);
    CHECK(face_at(drawing, {ids}, middle));
    ids.pop_back();
    CHECK(!face_at(drawing, {ids}, middle));
  }
}

}  // namespace
}  // namespace croquis
