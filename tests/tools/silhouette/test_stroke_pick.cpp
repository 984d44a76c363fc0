// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/tools/silhouette/stroke_edit.h"
#include "tools/strokes/drawn_strokes.h"

namespace croquis {
namespace {

Drawing three_strokes() {
  Drawing drawing;
  drawing.strokes = {test::circle("ring", {0, 0}, 100), test::stroke_through({{-200, 150}, {200, 150}}, "line"),
                     test::stroke_through({{300, 0}}, "dot")};
  return drawing;
}

TEST_CASE("the nearest stroke within reach is picked, with the place on it") {
  const Drawing drawing = three_strokes();
  const auto line = nearest_stroke(drawing, {30, 145});
  REQUIRE(line);
  CHECK(line->id == "line");
  CHECK((line->place - Vec2(30, 150)).norm() < 1e-9);
  CHECK(line->distance == Approx(5));
  CHECK(line->parameter == Approx(230.0 / 400));
  CHECK(nearest_stroke(drawing, {0, -103})->id == "ring");
  CHECK(nearest_stroke(drawing, {304, 0})->id == "dot");
  CHECK(!nearest_stroke(drawing, {30, 130}));
  CHECK(nearest_stroke(drawing, {30, 130}, {8, 3})->id == "line");
  CHECK(!nearest_stroke(drawing, {30, 145}, {8, 0.5}));
  CHECK(!nearest_stroke({}, {0, 0}));
}

TEST_CASE("a closed stroke is picked on its closing segment, an open one isn't") {
  Drawing drawing;
  drawing.strokes = {test::stroke_through({{0, 0}, {100, 0}, {100, 100}, {0, 100}}, "box", true)};
  CHECK(nearest_stroke(drawing, {1, 50})->segment == 3);
  drawing.strokes[0].closed = false;
  CHECK(!nearest_stroke(drawing, {1, 50}));
}

TEST_CASE("of two strokes at one place the one drawn last is picked") {
  Drawing drawing;
  drawing.strokes = {test::circle("below", {0, 0}, 50), test::circle("above", {0, 0}, 50)};
  CHECK(nearest_stroke(drawing, {52, 0})->id == "above");
}

TEST_CASE("picking agrees with a search over finely spaced places") {
  const Drawing drawing = three_strokes();
  test::Random random(8);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec2 place(random.between(-220, 320), random.between(-130, 180));
    double best = 1e9;
    for (const Stroke& stroke : drawing.strokes) {
      const std::size_t count = stroke.samples.size();
      for (std::size_t i = 0; i + 1 < count + (stroke.closed || count == 1 ? 1 : 0); ++i) {
        const Vec2& from = stroke.samples[i].position;
        const Vec2& to = stroke.samples[(i + 1) % count].position;
        const int steps = 1 + static_cast<int>(50 * (to - from).norm());
        for (int k = 0; k <= steps; ++k) best = std::min(best, (from + (to - from) * k / steps - place).norm());
      }
    }
    const auto picked = nearest_stroke(drawing, place, {40, 1});
    if (picked) CHECK(picked->distance == Approx(best).margin(0.02));
    if (!picked) CHECK(best > 39.9);
  }
}

TEST_CASE("the nearest anchor within reach is picked") {
  const std::vector<StrokeAnchor> anchors = {{{0, 0}, 0, false}, {{10, 0}, 5, false}, {{20, 0}, 9, true}};
  CHECK(nearest_anchor(anchors, {14, 1}) == 1U);
  CHECK(nearest_anchor(anchors, {16, 1}) == 2U);
  CHECK(!nearest_anchor(anchors, {14, 30}));
  CHECK(!nearest_anchor(anchors, {14, 1}, {8, 0.1}));
  CHECK(!nearest_anchor({}, {0, 0}));
}

TEST_CASE("a box picks strokes that pass through it, also without a sample in it") {
  const Drawing drawing = three_strokes();
  const auto ids = [&](const Vec2& a, const Vec2& b) { return strokes_in_box(drawing, PickBox::spanned(a, b)); };
  CHECK(ids({10, 140}, {20, 160}) == std::vector<std::string>{"line"});
  CHECK(ids({20, 160}, {10, 140}) == std::vector<std::string>{"line"});
  CHECK(ids({-50, -50}, {50, 50}).empty());
  CHECK(ids({-50, -120}, {50, 170}) == std::vector<std::string>{"ring", "line"});
  CHECK(ids({299, -1}, {301, 1}) == std::vector<std::string>{"dot"});
  CHECK(ids({-500, -500}, {500, 500}).size() == 3);
}

}  // namespace
}  // namespace croquis
