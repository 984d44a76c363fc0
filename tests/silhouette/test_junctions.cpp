// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/strokes/junctions.h"
#include "algorithms/silhouette/strokes/stroke_cleanup.h"
#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

Stroke line_stroke(const std::string& id, const Vec2& from, const Vec2& to) {
  Stroke stroke;
  stroke.id = id;
  for (int i = 0; i <= 100; ++i) stroke.samples.push_back({from + (to - from) * i / 100});
  return stroke;
}

struct Found {
  CleanDrawing clean;
  Junctions junctions;
};

Found find(const Drawing& drawing) {
  Found found{clean_strokes(drawing, {}, {}, Progress()), {}};
  meet_bars(found.clean.lines, {}, found.clean.scale, Progress());
  found.junctions = find_junctions(drawing, found.clean.lines, {}, {}, found.clean.scale, Progress());
  return found;
}

/// A bar along x and a stem that comes from below and ends `beyond` past it.
Drawing bar_and_stem(double beyond, double slant = 0) {
  Drawing drawing;
  drawing.strokes.push_back(line_stroke("bar", {0, 0}, {800, 0}));
  const Vec2 direction(std::sin(slant), std::cos(slant));
  const Vec2 meets(400, 0);
  drawing.strokes.push_back(line_stroke("stem", meets - 600 * direction, meets + beyond * direction));
  return drawing;
}

}  // namespace

TEST_CASE("a stem that stops short of its bar, or runs past it, ends on it") {
  for (const double beyond : {-8.0, -3.0, 0.0, 2.0, 8.0}) {
    for (const double slant : {-0.9, 0.0, 0.9}) {
      INFO(beyond << " beyond, slant " << slant);
      const Found found = find(bar_and_stem(beyond, slant));
      REQUIRE(found.junctions.ends.size() == 1);
      const HiddenEnd& end = found.junctions.ends.front();
      CHECK(end.line == 1);
      CHECK(end.bar == 0);
      CHECK((end.at - Vec2(400, 0)).norm() < 1e-6);
      CHECK((found.clean.lines[1].end(false) - end.at).norm() < 1e-6);
      CHECK(end.tangent.dot(Vec2(std::sin(slant), std::cos(slant))) == Approx(1));
      CHECK(found.junctions.sides[0] == 1);  // the bar runs to the right, the stem heads for its left
    }
  }
}

TEST_CASE("a stem too far from any line ends nowhere") {
  const Found found = find(bar_and_stem(-16));
  CHECK(found.junctions.ends.empty());
  CHECK(found.junctions.findings.size() == 4);
}

TEST_CASE("stems that were trimmed cross their bars once they are carried on") {
  for (const test::NamedSketch& named : test::all_sketches()) {
    INFO(named.name);
    Found found = find(named.sketch.drawing);
    CHECK(found.junctions.findings.empty());
    extend_behind_bars(found.clean.lines, found.junctions.ends, found.clean.scale);
    for (const HiddenEnd& end : found.junctions.ends) {
      const Points& stem = found.clean.lines[end.line].points;
      const Vec2& tip = end.at_start ? stem.front() : stem.back();
      const Vec2& before = end.at_start ? stem[1] : stem[stem.size() - 2];
      const CleanLine& bar = found.clean.lines[end.bar];
      int crossings = 0;
      for (Index i = 0; i < bar.segment_count(); ++i) {
        const Vec2& a = bar.points[i];
        const Vec2& b = bar.points[(i + 1) % bar.points.size()];
        crossings += orientation(a, b, tip) != orientation(a, b, before) &&
                     orientation(tip, before, a) != orientation(tip, before, b);
      }
      CHECK(crossings >= 1);  // 2 where it runs exactly through a sample of the bar
    }
  }
}

TEST_CASE("every stem of a true drawing heads for the surface of its bar") {
  for (const test::NamedSketch& named : test::all_sketches()) {
    INFO(named.name);
    const Found found = find(named.sketch.drawing);
    for (const HiddenEnd& end : found.junctions.ends) {
      const Vec2 ahead = end.at + 4 * found.clean.scale.unit * end.tangent;
      const Vec2 back = end.at - 4 * found.clean.scale.unit * end.tangent;
      CHECK(test::layers_at(named.sketch.truth, ahead) >= test::layers_at(named.sketch.truth, back));
    }
  }
}
