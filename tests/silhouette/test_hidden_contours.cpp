// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/figure/contour_completion.h"
#include "croquis/base/error.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/stroke_data.h"
#include "silhouette/labelled_counts.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/characters/rosette.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_generator.h"
#include "support/sketches/sketch_hand.h"
#include "support/sketches/sketch_spline.h"

using namespace croquis;
using namespace croquis::test;

namespace {

std::vector<Vec2> stick(const Vec2& from, const Vec2& to, double radius) {
  return tube_outline(bar(from, to, radius, [](double) { return 0.0; }));
}

std::vector<Vec2> oval(double a, double b) {
  std::vector<Vec2> points = circle_outline({0, 0}, a);
  for (Vec2& point : points) point.y() *= b / a;
  return points;
}

/// Outlines over one another, the last in front.
Sketch stacked(const std::vector<std::vector<Vec2>>& outlines) {
  std::vector<LayeredPart> parts;
  for (const std::vector<Vec2>& outline : outlines) parts.push_back({outline, static_cast<int>(parts.size())});
  return layered_sketch(parts);
}

Stroke hidden(const std::string& id, const std::vector<Vec2>& points) {
  Stroke stroke = stroke_of(id, points);
  stroke.data[silhouette::kind_key] = silhouette::to_string(silhouette::StrokeKind::Hidden);
  return stroke;
}

/// Two capsules on both sides of a disc, in line with one another: read as one stick behind it.
Drawing stick_behind_disc() {
  return stacked({stick({-320, -60}, {320, 60}, 14), circle_outline({0, 0}, 130)}).drawing;
}

/// The ends of the open strokes left (-1) or right (+1) of the disc, the lower one first.
std::vector<Vec2> ends_beside(const Drawing& drawing, double side) {
  std::vector<Vec2> ends;
  for (const Stroke& stroke : drawing.strokes) {
    if (stroke.closed) continue;
    for (const Vec2& end : {stroke.samples.front().position, stroke.samples.back().position}) {
      if (end.x() * side > 0) ends.push_back(end);
    }
  }
  std::sort(ends.begin(), ends.end(), [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
  return ends;
}

}  // namespace

TEST_CASE("a strip that goes straight on behind something is one part") {
  const std::vector<std::pair<const char*, Sketch>> sketches{
      {"an arrow through a heart", stacked({stick({-320, -60}, {320, 60}, 14), oval(140, 120)})},
      {"a long arrow", stacked({stick({-500, -60}, {500, 60}, 10), oval(220, 180)})},
      {"crossed arms behind a body",
       stacked({stick({-200, -120}, {200, 120}, 25), stick({-200, 120}, {200, -120}, 25), oval(110, 160)})},
      {"thin crossed sticks behind a disc",
       stacked({stick({-300, -150}, {300, 150}, 8), stick({-300, 150}, {300, -150}, 8), oval(180, 180)})},
      {"a bar behind something wide", stacked({stick({-400, 0}, {400, 0}, 12), oval(250, 150)})},
      {"a bar behind several things", stacked({stick({-400, 0}, {400, 0}, 20), circle_outline({-220, 0}, 70),
                                               circle_outline({0, 0}, 70), circle_outline({220, 0}, 70)})}};
  for (const auto& [name, sketch] : sketches) {
    for (const double turn : {0.0, 0.7}) {
      INFO(name << " turned by " << turn);
      const Sketch turned = rotated(sketch, turn);
      CHECK(counts_of(label_quietly(turned.drawing)) == counts_of(turned.truth));
      CHECK(counts_of(label_quietly(reversed_strokes(turned.drawing))) == counts_of(turned.truth));
      CHECK(counts_of(label_quietly(mirrored(turned).drawing)) == counts_of(turned.truth));
    }
  }
}

TEST_CASE("a strand goes on behind a strand, though a hand bent both of its sides there", "[hand]") {
  const Sketch trefoil = trefoil_sketch();
  HandOptions hand;
  hand.jitter = 0.02;
  int right = 0;
  for (std::uint64_t seed = 9401; seed < 9426; ++seed) {
    try {
      const auto labelled =
          label_quietly(drawn_by_hand(trefoil, seed, hand), silhouette::Options::of(silhouette::Preset::Tablet));
      right += counts_of(labelled).panels == counts_of(trefoil.truth).panels ? 1 : 0;
    } catch (const Error&) {
    }
  }
  CHECK(right >= 19);  // 16 if strips must be as even as a steady hand draws them
}

TEST_CASE("parts of steady drawings aren't taken for one strand that a hand bent") {
  for (const std::uint64_t seed : {14U, 20U, 95U, 118U, 236U}) {
    INFO("layers " << seed);
    const Sketch layers = random_layered_sketch(seed, 2 + static_cast<int>(seed % 8));
    CHECK(counts_of(label_quietly(layers.drawing)) == counts_of(layers.truth));
  }
}

TEST_CASE("what is hidden behind a bent part stays behind it") {
  const std::vector<Vec2> bent = smooth_loop({{-10, 80},
                                              {10, 115},
                                              {80, 118},
                                              {135, 90},
                                              {150, 0},
                                              {140, -90},
                                              {110, -100},
                                              {95, -80},
                                              {100, 0},
                                              {70, 60},
                                              {30, 60}});
  // Its ends lie at the bent part's two arms: what joins them straight lies in the open.
  const Spline round({{10, 115}, {0, 150}, {-80, 170}, {-180, 60}, {-150, -90}, {0, -120}, {70, -70}, {97, -50}},
                     false);
  std::vector<Vec2> behind;
  for (int i = 0; i <= 200; ++i) behind.push_back(round.at(i / 200.0));
  Drawing drawing = drawing_of({stroke_of("front", bent, true), stroke_of("behind", behind)});
  const silhouette::LabelledDrawing labelled =
      label_quietly(drawing, silhouette::Options::of(silhouette::Preset::Tablet));
  CHECK_FALSE(has_errors(labelled.findings));
  CHECK(counts_of(labelled).objects == 2);
}

TEST_CASE("ears behind a head are parts of their own") {
  for (const double height : {90.0, 105.0, 120.0}) {
    for (const double size : {35.0, 50.0}) {
      INFO(height << ", " << size);
      const Sketch sketch = stacked({circle_outline({-0.7 * height, 0.75 * height}, size),
                                     circle_outline({0.7 * height, 0.75 * height}, size), oval(100, 100)});
      CHECK(counts_of(label_quietly(sketch.drawing)) == counts_of(sketch.truth));
    }
  }
}

TEST_CASE("petals and arms all round a disc are parts of their own, whether or not they overlap") {
  for (const int limbs : {8, 16, 40}) {
    for (const double share : {0.5, 1.2, 1.5}) {
      INFO(limbs << " petals of width " << share);
      const Sketch flower = rosette_sketch(limbs, share, 1, 320, 0);
      CHECK(counts_of(label_quietly(flower.drawing)).objects == counts_of(flower.truth).objects);
    }
    for (const double bend : {0.0, 15.0}) {
      INFO(limbs << " arms bent by " << bend);
      const Sketch octopus = rosette_sketch(limbs, 0.6, 0.5, 320, bend);
      CHECK(counts_of(label_quietly(octopus.drawing)).objects == counts_of(octopus.truth).objects);
    }
  }
}

TEST_CASE("the two sides of a handle are joined, and those of a neck") {
  const auto bent = [](double out) {
    return limb_outline({{60, -60}, {120, -55}, {60 + out, 0}, {120, 55}, {60, 60}}, std::vector<double>(5, 14));
  };
  for (const double out : {110.0, 150.0}) {
    INFO("a handle that reaches out by " << out);
    const Sketch mug = stacked({bent(out), oval(100, 110)});
    CHECK(counts_of(label_quietly(mug.drawing)) == counts_of(mug.truth));
  }
  const Sketch giraffe = stacked(
      {limb_outline({{0, 0}, {-30, 130}, {-70, 260}}, {50, 38, 30}), oval(140, 70), circle_outline({-80, 290}, 60)});
  CHECK(counts_of(label_quietly(giraffe.drawing)) == counts_of(giraffe.truth));
}

TEST_CASE("what is drawn shows where a hidden piece would lie in the open") {
  silhouette::CleanLine disc;
  disc.points = circle_outline({0, 0}, 100);
  disc.closed = true;
  const auto missing = [](const silhouette::CleanLine& line, int side, const silhouette::Points& piece) {
    return silhouette::missing_surfaces(SegmentGrid(segments_of_lines(line), 10), {side}, piece);
  };
  CHECK(missing(disc, 1, {{-50, 0}, {0, 30}, {50, 0}}) == 0);
  CHECK(missing(disc, 1, {{-50, 0}, {0, 150}, {50, 0}}) == 1);
  // Behind the disc the piece went behind something else that is hidden there itself.
  CHECK(missing(disc, 1, {{-50, 0}, {0, 150}}) == 0);
  CHECK(missing(disc, 1, {{0, 150}, {-50, 0}, {0, -150}}) == 0);
  // Of a line whose side nothing shows, nothing is said.
  silhouette::CleanLine open = disc;
  open.closed = false;
  CHECK(missing(open, 0, {{-50, 0}, {0, 150}, {50, 0}}) == 0);
}

TEST_CASE("a hidden stroke is the contour between the two ends that are nearest") {
  const Drawing plain = stick_behind_disc();
  REQUIRE(counts_of(label_quietly(plain)).objects == 2);
  Drawing marked = plain;
  const std::vector<Vec2> left = ends_beside(plain, -1);
  REQUIRE(left.size() == 2);
  // The left piece is a limb of its own, as long as its cap says; drawn a little carelessly.
  const Vec2 tip(-60, 0.5 * (left[0].y() + left[1].y()) + 12);
  marked.strokes.push_back(
      hidden("cap", {left[0] + Vec2(3, 2), tip + Vec2(-10, -13), tip, tip + Vec2(-10, 13), left[1] + Vec2(-2, 3)}));
  for (const bool reversed : {false, true}) {
    const silhouette::LabelledDrawing labelled = label_quietly(reversed ? reversed_strokes(marked) : marked);
    CHECK_FALSE(has_errors(labelled.findings));
    CHECK(counts_of(labelled).objects == 3);
    double nearest = 1e9;
    for (const silhouette::LabelledFigure& figure : labelled.figures) {
      for (const silhouette::FigureCompletion& completion : figure.completions) {
        for (const Vec2& point : completion.points) nearest = std::min(nearest, (point - tip).norm());
      }
    }
    CHECK(nearest < 4);
  }
}

TEST_CASE("hidden strokes that lead from no end to another are named, and the rest is read without them") {
  const Drawing plain = stick_behind_disc();
  const std::vector<Vec2> left = ends_beside(plain, -1);
  Stroke closed = hidden("closed", circle_outline({0, 0}, 40));
  closed.closed = true;
  const Stroke loose = hidden("loose", {{-20, 0}, {20, 10}});
  const Stroke half = hidden("half", {left[0], {-40, 0}});
  const Stroke tiny = hidden("tiny", {{0, 0}, {1, 0}});
  for (const Stroke& stroke : {closed, loose, half, tiny}) {
    INFO(stroke.id);
    Drawing drawing = plain;
    drawing.strokes.push_back(stroke);
    const silhouette::LabelledDrawing labelled = label_quietly(drawing);
    const std::string code = stroke.id == "tiny" ? "W_TINY" : "E_HIDDEN_STROKE";
    REQUIRE(labelled.findings.size() == 1);
    CHECK(labelled.findings[0].code == code);
    REQUIRE(labelled.findings[0].subjects.size() == 1);
    CHECK(labelled.findings[0].subjects[0].id == stroke.id);
    CHECK(counts_of(labelled).objects == 2);
  }
}
