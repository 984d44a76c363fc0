// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/strokes/stroke_cleanup.h"
#include "silhouette/labelled_counts.h"
#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::silhouette;
using croquis::test::stroke_of;

namespace {

std::vector<Vec2> arc(double radius, double from, double to) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 200; ++i) {
    const double angle = (from + (to - from) * i / 200) * std::numbers::pi / 180;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

CleanDrawing clean(const Drawing& drawing, const StrokeOptions& options = {}) {
  return clean_strokes(drawing, options, {}, Progress());
}

int count_code(const Findings& findings, const std::string& code) {
  return static_cast<int>(
      std::count_if(findings.begin(), findings.end(), [&](const Finding& finding) { return finding.code == code; }));
}

/// A circle of diagonal 1000 (u = 1) as one open stroke with a hole of some length.
Drawing broken_circle(double hole) {
  const double radius = 500 / std::numbers::sqrt2;
  Drawing drawing;
  drawing.strokes.push_back(stroke_of("c", arc(radius, 0, 360 - hole / radius * 180 / std::numbers::pi)));
  return drawing;
}

}  // namespace

TEST_CASE("clean lines are sampled evenly, about a step apart") {
  for (const test::NamedSketch& named : test::all_sketches()) {
    INFO(named.name);
    const CleanDrawing cleaned = clean(named.sketch.drawing);
    for (const CleanLine& line : cleaned.lines) {
      for (Index i = 0; i < line.segment_count(); ++i) {
        const double length = (line.points[(i + 1) % line.points.size()] - line.points[i]).norm();
        CHECK(length < 1.3 * cleaned.scale.step);
        CHECK(length > 0.4 * cleaned.scale.step);
      }
    }
  }
}

TEST_CASE("smoothing a circle neither shrinks nor moves it") {
  StrokeOptions options;
  options.smoothing_passes = 8;
  const CleanDrawing cleaned = clean(broken_circle(0), options);
  REQUIRE(cleaned.lines.size() == 1);
  CHECK(cleaned.lines.front().closed);
  const double radius = 500 / std::numbers::sqrt2;
  for (const Vec2& point : cleaned.lines.front().points) CHECK(point.norm() == Approx(radius).epsilon(0.001));
}

TEST_CASE("small holes of a loop are closed and told, wide ones are left") {
  CHECK(clean(broken_circle(5)).lines.front().closed);
  CHECK(count_code(clean(broken_circle(5)).findings, "W_GAP") == 0);  // closing a loop is what was meant
  CHECK(clean(broken_circle(14)).lines.front().closed);
  CHECK(count_code(clean(broken_circle(14)).findings, "W_GAP") == 1);
  CHECK_FALSE(clean(broken_circle(25)).lines.front().closed);
}

TEST_CASE("a gap of 12 is joined wherever it is, round tight bends too") {
  int joined = 0;
  int drawn = 0;
  test::NoiseOptions options;
  options.undershoot = options.overshoot = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const test::Sketch& sketch : {test::trefoil_sketch(), test::snake_sketch(), test::ring_and_bar_sketch(),
                                       test::dog_sketch(), test::weave_sketch()}) {
      ++drawn;
      joined += count_code(clean(test::noisy(sketch.drawing, seed, options)).findings, "W_GAP") == 1;
    }
  }
  CHECK(drawn == 50);
  CHECK(joined >= 48);
}

TEST_CASE("the two pieces of a line that passes behind a thin one are not joined") {
  Drawing drawing;
  drawing.strokes.push_back(stroke_of("left", {{0, 0}, {495, 0}}));
  drawing.strokes.push_back(stroke_of("right", {{505, 0}, {1000, 0}}));
  CHECK(clean(drawing).lines.size() == 1);
  drawing.strokes.push_back(stroke_of("bar", {{500, -100}, {500, 100}}));
  CHECK(clean(drawing).lines.size() == 3);
}

TEST_CASE("an end that stops at a line near that line's own end is not joined to it") {
  // A tail begins on a body's outline 14 above the place where the outline passes behind a leg.
  Drawing drawing;
  drawing.strokes.push_back(stroke_of("body", arc(400, 5, 330)));
  const Vec2 start = 400 * Vec2(std::cos(0.122), std::sin(0.122));
  std::vector<Vec2> tail;
  for (int i = 0; i <= 100; ++i) tail.emplace_back(start + Vec2(2.0 * i, -1.7 * i - 0.005 * i * i));
  drawing.strokes.push_back(stroke_of("tail", tail));
  for (const bool reversed : {false, true}) {
    const CleanDrawing cleaned = clean(reversed ? test::reversed_strokes(drawing) : drawing);
    CHECK(cleaned.lines.size() == 2);
  }
}

TEST_CASE("joined strokes keep their names along the line, whichever way they were drawn") {
  Drawing drawing;
  drawing.strokes.push_back(stroke_of("a", {{400, 0}, {0, 0}}));
  drawing.strokes.push_back(stroke_of("b", {{1000, 0}, {410, 0}}));
  const CleanDrawing cleaned = clean(drawing);
  REQUIRE(cleaned.lines.size() == 1);
  const CleanLine& line = cleaned.lines.front();
  CHECK(line.end(true).x() == Approx(1000));
  CHECK(line.end(false).x() == Approx(0).margin(1e-9));
  CHECK(line.strokes == std::vector<Index>{1, 0});
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (std::abs(line.points[i].x() - 405) > 10) CHECK(line.stroke[i] == (line.points[i].x() > 405 ? 1U : 0U));
  }
}

TEST_CASE("sharp corners stay sharp") {
  Drawing drawing;
  std::vector<Vec2> square;
  for (const Vec2& corner : {Vec2(0, 0), Vec2(600, 0), Vec2(600, 600), Vec2(0, 600)}) square.push_back(corner);
  drawing.strokes.push_back(stroke_of("square", square, true));
  const CleanDrawing cleaned = clean(drawing);
  for (const Vec2& corner : square) {
    double nearest = 1e9;
    for (const Vec2& point : cleaned.lines.front().points) nearest = std::min(nearest, (point - corner).norm());
    CHECK(nearest < 1.5 * cleaned.scale.unit);
  }
}

TEST_CASE("strokes too short are left out by name, and the drawing stays as it was") {
  Drawing drawing = broken_circle(0);
  drawing.strokes.push_back(stroke_of("dot", {{0, 0}, {3, 0}}));
  const CleanDrawing cleaned = clean(drawing);
  CHECK(cleaned.lines.size() == 1);
  REQUIRE(count_code(cleaned.findings, "W_TINY") == 1);
  CHECK(test::strokes_named(cleaned.findings.back()) == std::vector<std::string>{"dot"});
  CHECK(drawing.strokes.size() == 2);
}
