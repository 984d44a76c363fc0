// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/tools/silhouette/stroke_edit.h"
#include "tools/strokes/drawn_strokes.h"

namespace croquis {
namespace {

using Ids = std::vector<std::string>;

std::vector<Vec2> line_of(const Vec2& a, const Vec2& b) {
  std::vector<Vec2> places;
  for (int i = 0; i <= 50; ++i) places.push_back(a + i / 50.0 * (b - a));
  return places;
}

/// A body, an ear whose ends rest on it, and a leg of which one end does.
Drawing animal() {
  Drawing drawing;
  drawing.strokes.push_back(test::circle("body", {0, 0}, 100, 240));
  std::vector<Vec2> ear = line_of({-30, 97}, {-30, 160});
  for (const Vec2& place : line_of({-28, 165}, {28, 165})) ear.push_back(place);
  for (const Vec2& place : line_of({30, 160}, {30, 97})) ear.push_back(place);
  drawing.strokes.push_back(test::stroke_through(ear, "ear"));
  drawing.strokes.push_back(test::stroke_through(line_of({0, -103}, {0, -300}), "leg"));
  drawing.strokes.push_back(test::stroke_through(line_of({5, -300}, {90, -300}), "foot"));
  for (Stroke& stroke : drawing.strokes) stroke.data["scale"] = "1";
  return drawing;
}

const Stroke& stroke(const DrawingEdit& edit, const std::string& id) { return *find_stroke(edit.drawing, id); }

TEST_CASE("ends that rest on a line follow it when it is moved, and their strokes bend smoothly") {
  const Drawing before = animal();
  const Vec2 by(12, -8);
  const DrawingEdit edit = move_strokes(before, {"body"}, by);
  CHECK(edit.changed == Ids{"body", "ear", "leg"});
  const Stroke& old_leg = before.strokes[2];
  const Stroke& leg = stroke(edit, "leg");
  CHECK((leg.samples.front().position - old_leg.samples.front().position - by).norm() < 1e-9);
  CHECK(leg.samples.back().position == old_leg.samples.back().position);
  double last_shift = by.norm() + 1e-9;
  for (std::size_t i = 0; i < leg.samples.size(); ++i) {
    const double shift = (leg.samples[i].position - old_leg.samples[i].position).norm();
    CHECK(shift <= last_shift);  // fades out
    last_shift = shift + 1e-9;
  }
  // Both ends of the ear moved alike: so did all of it.
  for (std::size_t i = 0; i < before.strokes[1].samples.size(); ++i) {
    const Vec2 moved = stroke(edit, "ear").samples[i].position - before.strokes[1].samples[i].position;
    CHECK((moved - by).norm() < 1e-9);
  }
}

TEST_CASE("what is dragged itself stays as it is dragged, and leaves the line that it rested on alone") {
  const Drawing before = animal();
  const DrawingEdit edit = move_strokes(before, {"ear"}, {40, 0});
  CHECK(edit.changed == Ids{"ear"});
  const DrawingEdit both = move_strokes(before, {"body", "ear"}, {5, 5});
  CHECK(both.changed == Ids{"body", "ear", "leg"});
  CHECK(stroke(both, "ear").samples[10].position == before.strokes[1].samples[10].position + Vec2(5, 5));
}

TEST_CASE("ends follow a line that is bent by the place they rest on, and others rest on what follows") {
  const Drawing before = animal();
  const DrawingEdit moved = move_strokes(before, {"foot"}, {0, -20});
  CHECK(moved.changed == Ids{"foot", "leg"});  // the leg's end lies on the foot's
  CHECK((stroke(moved, "leg").samples.back().position - Vec2(0, -320)).norm() < 1e-9);
  CHECK(stroke(moved, "leg").samples.front().position == before.strokes[2].samples.front().position);

  const StrokeFit fit = fit_in_drawing(before, before.strokes[0]);
  const auto lowest = std::min_element(fit.anchors.begin(), fit.anchors.end(),
                                       [](const auto& a, const auto& b) { return a.position.y() < b.position.y(); });
  const auto anchor = static_cast<std::size_t>(lowest - fit.anchors.begin());
  const DrawingEdit bent = drag_anchor(before, "body", fit, anchor, {0, -30});
  const Stroke& body = stroke(bent, "body");
  double nearest = 1e300;
  for (const StrokeSample& sample : body.samples)
    nearest = std::min(nearest, (sample.position - stroke(bent, "leg").samples.front().position).norm());
  CHECK(nearest < 6);
  CHECK(stroke(bent, "leg").samples.front().position.y() < -105);
  CHECK(stroke(bent, "leg").samples.back().position == before.strokes[2].samples.back().position);
}

TEST_CASE("an end follows the line nearest to it alone, and only within reach of its pen's view") {
  Drawing drawing;
  drawing.strokes = {test::circle("near", {0, 0}, 100), test::circle("far", {0, 0}, 106),
                     test::stroke_through(line_of({0, 98}, {0, 20}), "limb")};
  for (Stroke& one : drawing.strokes) one.data["scale"] = "1";
  CHECK(move_strokes(drawing, {"far"}, {0, 5}).changed == Ids{"far"});
  CHECK(move_strokes(drawing, {"near"}, {0, 5}).changed == Ids{"near", "limb"});
  drawing.strokes[2].data["scale"] = "0.1";  // drawn near by: two units are twenty pixels
  CHECK(move_strokes(drawing, {"near"}, {0, 5}).changed == Ids{"near"});
}

TEST_CASE("lines that rest on each other in any way follow one another once, and nothing else moves") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    test::Random random(seed);
    Drawing drawing;
    for (int k = 0; k < 8; ++k) {
      const Vec2 a(random.between(0, 100), random.between(0, 100));
      const Vec2 b(random.between(0, 100), random.between(0, 100));
      drawing.strokes.push_back(test::stroke_through(line_of(a, b), "s" + std::to_string(k)));
      drawing.strokes.back().data["scale"] = "1";
    }
    const DrawingEdit edit = move_strokes(drawing, {"s0"}, {3, 2});
    INFO(seed);
    CHECK(Ids(edit.changed.begin(), edit.changed.begin() + 1) == Ids{"s0"});
    CHECK(edit.drawing.strokes.size() == drawing.strokes.size());
    for (const Stroke& one : edit.drawing.strokes) {
      for (const StrokeSample& sample : one.samples) CHECK(sample.position.allFinite());
      const bool changed = std::count(edit.changed.begin(), edit.changed.end(), one.id) > 0;
      const Stroke& old = *find_stroke(drawing, one.id);
      const bool moved = one.samples.front().position != old.samples.front().position ||
                         one.samples.back().position != old.samples.back().position;
      CHECK((changed || !moved));
    }
  }
}

}  // namespace
}  // namespace croquis
