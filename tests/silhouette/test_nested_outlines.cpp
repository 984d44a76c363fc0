// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include <catch2/catch.hpp>

#include "croquis/silhouette/labelled_figure.h"
#include "silhouette/labelled_counts.h"
#include "silhouette/solids.h"
#include "support/sketches/sketch_layers.h"
#include "support/sketches/sketch_modifiers.h"

namespace croquis::silhouette {
namespace {

using test::euler_numbers;
using test::label_quietly;

/// What each nested stroke was read as.
std::map<std::string, std::string> readings(const Drawing& drawing) {
  std::map<std::string, std::string> read_as;
  for (const LabelledFigure& figure : label_quietly(drawing).figures) {
    for (const NestedOutline& nested : figure.nested) {
      read_as[drawing.strokes[nested.stroke].id] = nested.hole ? "hole" : "part";
    }
  }
  return read_as;
}

/// A shape with another one in it.
Drawing pair_of(const std::vector<Vec2>& outer, const std::vector<Vec2>& inner) {
  return test::drawing_of({test::stroke_of("outer", outer, true), test::stroke_of("inner", inner, true)});
}

Drawing ring() { return pair_of(test::circle_outline({0, 0}, 200), test::circle_outline({0, 0}, 120)); }
Drawing eye() { return pair_of(test::circle_outline({0, 0}, 200), test::circle_outline({60, 70}, 25)); }

TEST_CASE("eyes, bellies and buttons are parts in front; rings of even width go round holes") {
  const std::vector<std::string> holes{"doughnut", "mug in one line", "glasses",
                                       "key",      "scissors",        "bone through a ring"};
  for (const char* name : {"cat",     "fish",   "duck",     "car",
                           "owl",     "pig",    "penguin",  "mushroom",
                           "robot",   "rocket", "boat",     "person",
                           "snowman", "whale",  "doughnut", "mug in one line",
                           "glasses", "key",    "scissors", "bone through a ring"}) {
    INFO(name);
    const test::Sketch sketch = test::character_named(name);
    std::vector<int> expected = sketch.truth.euler_region;
    std::sort(expected.begin(), expected.end());
    const LabelledDrawing labelled = label_quietly(sketch.drawing);
    CHECK(euler_numbers(labelled) == expected);
    const bool has_hole = std::find(holes.begin(), holes.end(), name) != holes.end();
    CHECK((expected.front() < 1) == has_hole);
  }
}

TEST_CASE("how a nested outline is read doesn't depend on place, size, view or order") {
  const auto turn = Eigen::Affine2d(Eigen::Rotation2Dd(0.7)) * Eigen::Scaling(0.01);
  for (const char* name : {"teddy", "car", "penguin", "mug in one line", "rocket", "scissors"}) {
    INFO(name);
    const test::Sketch sketch = test::character_named(name);
    const auto expected = readings(sketch.drawing);
    CHECK(!expected.empty());
    CHECK(readings(test::transformed(sketch, Eigen::Affine2d(turn)).drawing) == expected);
    CHECK(readings(test::mirrored(sketch).drawing) == expected);
    CHECK(readings(test::reversed_strokes(sketch.drawing)) == expected);
    CHECK(readings(test::shuffled_strokes(sketch.drawing, 5)) == expected);
  }
}

TEST_CASE("a ring is a ring at any width, until it is a small thing on a big one") {
  for (const double radius : {90.0, 100.0, 130.0, 160.0, 190.0}) {
    INFO(radius);
    CHECK(readings(pair_of(test::circle_outline({0, 0}, 200), test::circle_outline({0, 0}, radius)))["inner"] ==
          "hole");
  }
  for (const double radius : {5.0, 20.0, 40.0}) {
    INFO(radius);
    CHECK(readings(pair_of(test::circle_outline({0, 0}, 200), test::circle_outline({0, 0}, radius)))["inner"] ==
          "part");
  }
}

TEST_CASE("what a stroke says of itself counts more than its shape") {
  Drawing marked = ring();
  marked.strokes[1].data["kind"] = "part";
  CHECK(euler_numbers(label_quietly(marked)) == std::vector<int>{1, 1});
  CHECK(label_quietly(marked).findings.empty());
  marked.strokes[1].data["kind"] = "hole";
  CHECK(euler_numbers(label_quietly(marked)) == std::vector<int>{0});
  marked = eye();
  marked.strokes[1].data["kind"] = "hole";
  CHECK(euler_numbers(label_quietly(marked)) == std::vector<int>{0});
}

TEST_CASE("outlines of different objects are no holes of each other, those of one object are") {
  Drawing grouped = ring();
  grouped.strokes[0].object = "wheel";
  grouped.strokes[1].object = "hub";
  CHECK(readings(grouped)["inner"] == "part");
  grouped.strokes[0].object.clear();
  CHECK(readings(grouped)["inner"] == "part");
  grouped = eye();
  for (Stroke& stroke : grouped.strokes) stroke.object = "washer";
  CHECK(readings(grouped)["inner"] == "hole");
}

TEST_CASE("what lies in a hole is a part of its own, and what lies on that is judged anew") {
  Drawing target = ring();
  target.strokes.push_back(test::stroke_of("ball", test::circle_outline({10, 0}, 70), true));
  target.strokes.push_back(test::stroke_of("spot", test::circle_outline({30, 20}, 12), true));
  const auto read_as = readings(target);
  CHECK(read_as.at("inner") == "hole");
  CHECK_FALSE(read_as.contains("ball"));
  CHECK(read_as.at("spot") == "part");
  CHECK(euler_numbers(label_quietly(target)) == std::vector<int>{0, 1, 1});
}

TEST_CASE("how a nested outline was read is reported, with its name and the other reading") {
  const Findings findings = label_quietly(eye()).findings;
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == "W_NESTED");
  CHECK(findings[0].severity == Severity::Info);
  CHECK(findings[0].message.find("\"inner\"") != std::string::npos);
  CHECK(findings[0].message.find("part in front") != std::string::npos);
}

TEST_CASE("a kind that is none is refused by name") {
  Drawing wrong = eye();
  wrong.strokes[1].data["kind"] = "wart";
  const Findings findings = label_quietly(wrong).findings;
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == "E_NOT_SUPPORTED");
  CHECK(findings[0].message.find("\"wart\"") != std::string::npos);
}

}  // namespace
}  // namespace croquis::silhouette
