// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/geometry/polyline.h"
#include "croquis/tools/silhouette/stroke_erasing.h"
#include "tools/strokes/drawn_strokes.h"

namespace croquis {
namespace {

using Ids = std::vector<std::string>;

std::vector<Vec2> places(const Stroke& stroke) {
  std::vector<Vec2> all;
  for (const StrokeSample& sample : stroke.samples) all.push_back(sample.position);
  return all;
}

double distance_to_path(const Vec2& place, const std::vector<Vec2>& path) {
  double least = (place - path.front()).norm();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double t = nearest_parameter(place, path[i - 1], path[i]);
    least = std::min(least, (path[i - 1] + t * (path[i] - path[i - 1]) - place).norm());
  }
  return least;
}

Stroke straight_line(const std::string& id) {
  std::vector<Vec2> all;
  for (int i = 0; i <= 100; ++i) all.emplace_back(3.0 * i, 0);
  Stroke line = test::stroke_through(all, id);
  for (std::size_t i = 0; i < line.samples.size(); ++i) line.samples[i].time = 0.01 * static_cast<double>(i);
  return line;
}

TEST_CASE("a stretch of a line is cut out exactly, and the rest keeps its samples") {
  Drawing drawing;
  drawing.strokes = {straight_line("a"), straight_line("b")};
  for (StrokeSample& sample : drawing.strokes[1].samples) sample.position.y() += 100;
  const DrawingEdit edit = erase_along(drawing, {{100, -20}, {100, 20}}, 5);
  CHECK(edit.changed == Ids{"a"});
  CHECK(edit.added == Ids{"stroke 1"});
  CHECK(edit.removed.empty());
  REQUIRE(edit.drawing.strokes.size() == 3);
  CHECK(edit.drawing.strokes[1].id == "stroke 1");  // where it was drawn
  const Stroke& left = edit.drawing.strokes[0];
  const Stroke& right = edit.drawing.strokes[1];
  CHECK((left.samples.back().position - Vec2(95, 0)).norm() < 1e-9);
  CHECK((right.samples.front().position - Vec2(105, 0)).norm() < 1e-9);
  CHECK(left.samples[20].position == drawing.strokes[0].samples[20].position);
  CHECK(right.samples.back().position == Vec2(300, 0));
  CHECK(right.samples.front().time == 0);
  CHECK(right.samples.back().time == Approx(0.65));
  CHECK(edit.drawing.strokes[2].samples.size() == 101);
}

TEST_CASE("a closed stroke becomes an open one; cut twice it falls apart") {
  Drawing drawing;
  drawing.strokes = {test::circle("ring", {0, 0}, 100)};
  drawing.strokes[0].data = {{"kind", "hole"}, {"scale", "2"}};
  const DrawingEdit once = erase_along(drawing, {{-100, 0}}, 10);
  REQUIRE(once.drawing.strokes.size() == 1);
  const Stroke& arc = once.drawing.strokes[0];
  CHECK(!arc.closed);
  CHECK(!arc.data.contains("kind"));  // an open line bounds no hole
  CHECK(arc.data.at("scale") == "2");
  CHECK(length(places(arc), false) == Approx(2 * 3.14159265 * 100 - 20).epsilon(0.001));
  for (std::size_t i = 1; i < arc.samples.size(); ++i) CHECK(arc.samples[i].time >= arc.samples[i - 1].time);
  const DrawingEdit twice = erase_along(drawing, {{0, -150}, {0, 150}}, 5);
  CHECK(twice.drawing.strokes.size() == 2);
  CHECK(twice.added.size() == 1);
}

TEST_CASE("rests shorter than the eraser go as well, and nearly all of a stroke is all of it") {
  Drawing drawing;
  drawing.strokes = {straight_line("a")};
  CHECK(erase_along(drawing, {{20, 0}}, 15).added.empty());  // 5 would be left of it
  const DrawingEdit all = erase_along(drawing, {{25, 0}, {300, 0}}, 4);
  CHECK(all.removed == Ids{"a"});
  CHECK(all.drawing.strokes.empty());
  CHECK(erase_along(drawing, {{60, 0}, {300, 0}}, 4).removed.empty());
  CHECK(!erase_along(drawing, {{60, 9}, {300, 9}}, 4).any());
  CHECK(!erase_along(drawing, {}, 4).any());
  Drawing dot;
  dot.strokes = {test::stroke_through({{5, 5}}, "dot")};
  CHECK(erase_along(dot, {{6, 5}}, 2).removed == Ids{"dot"});
}

TEST_CASE("what passes behind a stroke that fell apart passes behind its pieces") {
  Drawing drawing;
  drawing.strokes = {straight_line("a"), straight_line("b")};
  for (StrokeSample& sample : drawing.strokes[1].samples) sample.position.y() += 100;
  drawing.strokes[1].data["behind"] = "a";
  const DrawingEdit edit = erase_along(drawing, {{100, -20}, {100, 20}}, 5);
  CHECK(edit.drawing.strokes[2].data.at("behind") == "a,stroke 1");
}

TEST_CASE("whatever is erased, what is left is what the eraser didn't cover, and undoing is the drawing before") {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    test::Random random(seed);
    Drawing drawing;
    for (const test::DrawnCurve& curve : test::drawn_curves()) {
      drawing.strokes.push_back(test::sampled(curve, curve.name));
      drawing.strokes.back().closed = curve.closed;
    }
    std::vector<Vec2> path;
    for (std::uint32_t k = 0; k < 1 + random.below(12); ++k)
      path.emplace_back(random.between(-150, 250), random.between(-150, 250));
    const double radius = random.between(1, 20);
    INFO(seed);
    const DrawingEdit edit = erase_along(drawing, path, radius);
    std::set<std::string> ids;
    for (const Stroke& stroke : edit.drawing.strokes) {
      CHECK(ids.insert(stroke.id).second);
      CHECK(!stroke.samples.empty());
      for (const StrokeSample& sample : stroke.samples) {
        const bool was_touched = find_stroke(drawing, stroke.id) == nullptr ||
                                 std::count(edit.changed.begin(), edit.changed.end(), stroke.id) > 0;
        if (was_touched) CHECK(distance_to_path(sample.position, path) > radius - 1e-6);
      }
    }
    const auto erased = erased_pieces(drawing, path, radius);
    CHECK(erased.empty() == !edit.any());
    for (const auto& piece : erased) {
      for (const Vec2& place : piece) CHECK(distance_to_path(place, path) < radius + 1e-6);
    }
    const DrawingEdit again = erase_along(edit.drawing, path, radius * 0.999);
    CHECK(!again.any());
  }
}

}  // namespace
}  // namespace croquis
