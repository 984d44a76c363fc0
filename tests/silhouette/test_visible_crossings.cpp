// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/silhouette/attachment.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/stroke_data.h"
#include "silhouette/labelled_counts.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::test;
using silhouette::CrossingInView;
using silhouette::LabelledDrawing;
using silhouette::LabelledFigure;
using silhouette::Options;

namespace {

Options front_options() {
  Options options = Options::of(silhouette::Preset::Clean);
  options.strokes.crossings = silhouette::Crossings::Front;
  return options;
}

LabelledDrawing label_in_view(const Drawing& drawing) { return label_quietly(drawing, front_options()); }

/// All outlines in full, those behind drawn first.
Drawing in_full(const SketchTruth& truth) {
  std::vector<std::size_t> order(truth.outlines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return truth.outlines[a].height.front() < truth.outlines[b].height.front();
  });
  Drawing drawing;
  for (const std::size_t i : order) {
    drawing.strokes.push_back(stroke_of("o" + std::to_string(i), truth.outlines[i].points, true));
  }
  return drawing;
}

bool any_within_another(const SketchTruth& truth) {
  return std::ranges::any_of(truth.outlines, [&](const TrueContour& inner) {
    return std::ranges::any_of(truth.outlines, [&](const TrueContour& outer) {
      return &inner != &outer &&
             std::ranges::all_of(inner.points, [&](const Vec2& place) { return winding(outer.points, place) != 0; });
    });
  });
}

std::vector<Vec2> ellipse(const Vec2& centre, double a, double b, double turn) {
  std::vector<Vec2> points;
  for (int i = 0; i < 160; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.31) / 160;
    const Vec2 place(a * std::cos(angle), b * std::sin(angle));
    points.emplace_back(centre + Vec2(std::cos(turn) * place.x() - std::sin(turn) * place.y(),
                                      std::sin(turn) * place.x() + std::cos(turn) * place.y()));
  }
  return points;
}

std::vector<LayeredPart> teddy_parts() {
  return {{ellipse({0, 0}, 150, 180, 0), 0},        {ellipse({0, 240}, 120, 110, 0), 1},
          {ellipse({-100, 330}, 45, 45, 0), 2},     {ellipse({100, 330}, 45, 45, 0), 3},
          {ellipse({-165, 60}, 95, 40, -0.5), 4},   {ellipse({165, 60}, 95, 40, 0.5), 5},
          {ellipse({-100, -180}, 55, 90, -0.4), 6}, {ellipse({100, -180}, 55, 90, 0.4), 7}};
}

Drawing two_circles(double distance, const Vec2& direction = {1, 0}) {
  return drawing_of({stroke_of("a", circle_outline({0, 0}, 100), true),
                     stroke_of("b", circle_outline(distance * direction, 80), true)});
}

/// A limb that hangs down over a circle, its two ends open inside it.
Stroke limb_stroke(double bottom) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 60; ++i) points.emplace_back(-30, bottom + (200 - bottom) * i / 60);
  for (int i = 1; i < 30; ++i) {
    const double angle = std::numbers::pi * i / 30;
    points.emplace_back(-30 * std::cos(angle), 200 + 30 * std::sin(angle));
  }
  for (int i = 60; i >= 0; --i) points.emplace_back(30, bottom + (200 - bottom) * i / 60);
  return stroke_of("limb", points);
}

std::vector<Vec2> straight(const Vec2& from, const Vec2& to) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 100; ++i) points.emplace_back(from + (to - from) * i / 100);
  return points;
}

/// Names of the objects in front and behind, for each overlap of all figures.
std::vector<std::pair<std::string, std::string>> overlaps_of(const LabelledDrawing& labelled) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const LabelledFigure& figure : labelled.figures) {
    for (const auto& overlap : figure.overlaps) {
      names.emplace_back(figure.objects[overlap.upper].name, figure.objects[overlap.lower].name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

using Overlaps = std::vector<std::pair<std::string, std::string>>;

}  // namespace

TEST_CASE("shapes drawn in full over one another lie in the order of drawing") {
  const int count = sample_count(12, 400);
  int nested = 0;
  for (int seed = 1; seed <= count; ++seed) {
    INFO("seed " << seed);
    const Sketch sketch = random_layered_sketch(static_cast<std::uint64_t>(seed), 2 + seed % 11);
    if (any_within_another(sketch.truth)) {  // may as well be a hole
      ++nested;
      continue;
    }
    const Drawing drawing = in_full(sketch.truth);
    const LabelledDrawing labelled = label_in_view(drawing);
    CHECK(counts_of(labelled) == counts_of(sketch.truth));
    for (const auto& [upper, lower] : overlaps_of(labelled)) {
      const auto height = [&](const std::string& name) {
        return sketch.truth.outlines[static_cast<std::size_t>(std::stoi(name.substr(1)))].height.front();
      };
      CHECK(height(upper) > height(lower));
    }
    for (const CrossingInView& pair : labelled.crossings) CHECK(pair.front > pair.behind);
    CHECK(labelled.findings.size() == labelled.crossings.size());
    for (const Finding& finding : labelled.findings) CHECK(finding.code == "W_CROSS");
  }
  CHECK(20 * nested <= count);
}

TEST_CASE("of two closed outlines that cross, the one in front is suggested to rest on the other") {
  Drawing drawing = drawing_of({stroke_of("far", ellipse({300, 300}, 120, 120, 0), true),
                                stroke_of("near", ellipse({440, 320}, 120, 120, 0), true)});
  LabelledDrawing labelled = label_in_view(drawing);
  REQUIRE(labelled.crossings.size() == 1);
  CHECK(labelled.crossings.front().whole);
  std::vector<silhouette::AttachSuggestion> pairs = attach_suggestions(labelled.figures.front());
  REQUIRE(pairs.size() == 1);
  CHECK(pairs.front().hold == silhouette::Hold::Resting);

  // A line that ends within the other is the outline of a limb.
  std::vector<Vec2> limb;
  for (int degrees = -155; degrees <= 155; ++degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    limb.emplace_back(440 + 120 * std::cos(angle), 320 + 120 * std::sin(angle));
  }
  drawing.strokes[1] = stroke_of("near", limb, false);
  labelled = label_in_view(drawing);
  REQUIRE(labelled.crossings.size() == 1);
  CHECK_FALSE(labelled.crossings.front().whole);
  pairs = attach_suggestions(labelled.figures.front());
  REQUIRE(pairs.size() == 1);
  CHECK(pairs.front().hold == silhouette::Hold::Joined);
}

TEST_CASE("strokes set to lie behind what isn't there, or behind themselves, are named") {
  Drawing drawing = drawing_of({stroke_of("far", ellipse({300, 300}, 120, 120, 0), true),
                                stroke_of("near", ellipse({440, 320}, 120, 120, 0), true)});
  const auto warned = [&](const std::string& behind) {
    drawing.strokes[1].data[silhouette::behind_key] = behind;
    std::vector<std::string> sentences;
    for (const Finding& finding : label_in_view(drawing).findings) {
      if (finding.code != "W_BEHIND") continue;
      sentences.push_back(finding.message);
      CHECK(finding.subjects.front().id == "near");
    }
    return sentences;
  };
  CHECK(warned("far").empty());
  CHECK(warned("all").empty());
  CHECK(warned("").empty());
  REQUIRE(warned("far, wing").size() == 1);
  CHECK(warned("far, wing").front().find("\"wing\"") != std::string::npos);
  REQUIRE(warned("near").size() == 1);
  CHECK(warned("near").front().find("itself") != std::string::npos);
}

TEST_CASE("a character of full ellipses is read part by part") {
  const Sketch sketch = layered_sketch(teddy_parts());
  const Drawing drawing = in_full(sketch.truth);
  const LabelledDrawing labelled = label_in_view(drawing);
  CHECK(counts_of(labelled) == counts_of(sketch.truth));
  CHECK(labelled.crossings.size() == 7);
  CHECK(counts_of(label_in_view(reversed_strokes(drawing))) == counts_of(sketch.truth));
  for (const Finding& finding : findings_of(drawing, Options::of(silhouette::Preset::Clean)))
    CHECK(finding.code == "E_CROSS");
}

TEST_CASE("the hidden piece of an outline that was drawn in full is the one that was drawn") {
  const LabelledDrawing labelled = label_in_view(two_circles(130));
  REQUIRE(labelled.figures.size() == 1);
  const LabelledFigure& figure = labelled.figures.front();
  CHECK(figure.completions.empty());
  CHECK(std::ranges::count_if(figure.arcs, [](const auto& arc) { return !arc.visible && arc.depth == 1; }) == 1);
  for (const auto& contour : figure.contours) {
    const bool first = contour.strokes == std::vector<Index>{0};
    for (const Index v : contour.vertices) {
      const Vec2 centre(first ? 0 : 130, 0);
      CHECK((figure.points[v] - centre).norm() == Approx(first ? 100 : 80).margin(0.35));
    }
    CHECK(contour.strokes.size() == 1);
  }
}

TEST_CASE("a stroke that is set to lie behind does") {
  Drawing drawing = two_circles(130);
  CHECK(overlaps_of(label_in_view(drawing)) == Overlaps{{"b", "a"}});
  drawing.strokes[1].data["behind"] = "a";
  const LabelledDrawing changed = label_in_view(drawing);
  CHECK(overlaps_of(changed) == Overlaps{{"a", "b"}});
  REQUIRE(changed.crossings.size() == 1);
  CHECK(changed.crossings.front().front == 0);
  CHECK(changed.crossings.front().behind == 1);
  CHECK(changed.crossings.front().chosen);
  drawing.strokes[1].data["behind"] = "all";
  CHECK(overlaps_of(label_in_view(drawing)) == Overlaps{{"a", "b"}});
}

TEST_CASE("each pair of a chain of circles is decided by itself") {
  Drawing drawing;
  for (int i = 0; i < 6; ++i) {
    const double angle = std::numbers::pi * i / 3;
    const Vec2 centre(150 * std::cos(angle), 150 * std::sin(angle));
    drawing.strokes.push_back(stroke_of("c" + std::to_string(i), circle_outline(centre, 95), true));
  }
  // Set so that each lies over the next, all round: no order of the whole circles does that.
  drawing.strokes[0].data["behind"] = "";
  for (int i = 1; i < 5; ++i) drawing.strokes[static_cast<std::size_t>(i)].data["behind"] = "c" + std::to_string(i - 1);
  drawing.strokes[5].data["behind"] = "c4";
  const LabelledDrawing labelled = label_in_view(drawing);
  CHECK(overlaps_of(labelled) ==
        Overlaps{{"c0", "c1"}, {"c1", "c2"}, {"c2", "c3"}, {"c3", "c4"}, {"c4", "c5"}, {"c5", "c0"}});
  CHECK(counts_of(labelled).euler_region == 6);
}

TEST_CASE("long shapes that cross twice are one part each") {
  Drawing drawing = drawing_of({stroke_of("flat", ellipse({0, 0}, 250, 50, 0.1), true),
                                stroke_of("upright", ellipse({0, 0}, 250, 50, 1.6), true)});
  const LabelledDrawing labelled = label_in_view(drawing);
  CHECK(overlaps_of(labelled) == Overlaps{{"upright", "flat"}});
  CHECK(counts_of(labelled).crossings == 4);
  CHECK(labelled.crossings.size() == 1);
}

TEST_CASE("outlines that nearly touch are read one way or the other, at any distance and angle") {
  // The circles touch at a distance of 180.
  for (double distance = 170; distance <= 186; distance += 0.5) {
    for (const double angle : {0.0, 0.4, 1.1}) {
      INFO(distance << " at " << angle);
      const LabelledDrawing labelled = label_in_view(two_circles(distance, {std::cos(angle), std::sin(angle)}));
      const LabelledCounts counts = counts_of(labelled);
      CHECK(counts.objects == 2);
      CHECK(counts.euler_region == 2);
      if (distance <= 178) CHECK(counts.crossings == 2);
      if (distance >= 181) CHECK(counts.crossings == 0);
    }
  }
}

TEST_CASE("an unsteady line crosses another once") {
  for (int seed = 1; seed <= sample_count(40, 400); ++seed) {
    INFO("seed " << seed);
    Random random(static_cast<std::uint64_t>(seed));
    Drawing drawing = two_circles(random.between(100, 177));
    NoiseOptions noise;
    noise.amplitude = 2;
    noise.gap = 0;
    const LabelledCounts counts = counts_of(label_quietly(noisy(drawing, static_cast<std::uint64_t>(seed), noise),
                                                          Options::of(silhouette::Preset::Tablet)));
    CHECK(counts.objects == 2);
    CHECK(counts.euler_region == 2);
  }
}

TEST_CASE("outlines of an exact drawing that overlap a little cross, however uneven they are") {
  const auto cloud = [](const Vec2& centre) {
    std::vector<Vec2> points;
    for (int i = 0; i < 400; ++i) {
      const double angle = 2 * std::numbers::pi * i / 400;
      const double radius = 100 * (1 + 0.03 * std::sin(9 * angle));
      points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
  };
  Drawing drawing = drawing_of({stroke_of("left", cloud({0, 0}), true), stroke_of("right", cloud({193, 0}), true)});
  // Its ends lie on the left one, as a program puts them.
  std::vector<Vec2> limb;
  for (int i = 0; i <= 40; ++i) limb.push_back(cloud({0, 0})[static_cast<std::size_t>(190)] + Vec2(-3.0 * i, 0));
  for (int i = 1; i <= 40; ++i) limb.push_back(limb[40] + i / 40.0 * (cloud({0, 0})[210] + Vec2(-120, 0) - limb[40]));
  for (int i = 1; i <= 40; ++i) limb.push_back(cloud({0, 0})[210] + Vec2(-120 + 3.0 * i, 0));
  drawing.strokes.push_back(stroke_of("limb", limb));
  const LabelledDrawing labelled = label_quietly(drawing, Options::of(silhouette::Preset::Auto));
  REQUIRE(labelled.crossings.size() == 1);
  CHECK(overlaps_of(labelled) == Overlaps{{"left", "limb"}, {"right", "left"}});
}

TEST_CASE("a closed outline covers what crosses it") {
  for (const bool first : {false, true}) {
    Drawing drawing;
    const Stroke ball = stroke_of("ball", circle_outline({0, 0}, 60), true);
    if (first) drawing.strokes.push_back(ball);
    drawing.strokes.push_back(stroke_of("left", circle_outline({-260, 0}, 70), true));
    drawing.strokes.push_back(stroke_of("right", circle_outline({260, 0}, 70), true));
    drawing.strokes.push_back(stroke_of("top", straight({-200, 20}, {200, 20})));
    drawing.strokes.push_back(stroke_of("bottom", straight({-200, -20}, {200, -20})));
    if (!first) drawing.strokes.push_back(ball);
    const LabelledDrawing labelled = label_in_view(drawing);
    CHECK(overlaps_of(labelled) == Overlaps{{"ball", "top"}, {"left", "top"}, {"right", "top"}});
    CHECK(counts_of(labelled).objects == 4);
  }
}

TEST_CASE("a limb whose ends are seen inside a body lies in front of it, whichever was drawn first") {
  const Stroke body = stroke_of("body", circle_outline({0, 0}, 100), true);
  const Stroke limb = limb_stroke(-10);
  for (const bool limb_first : {false, true}) {
    Drawing drawing;
    drawing.strokes = limb_first ? std::vector<Stroke>{limb, body} : std::vector<Stroke>{body, limb};
    const LabelledDrawing labelled = label_in_view(drawing);
    CHECK(overlaps_of(labelled) == Overlaps{{"limb", "body"}});
    CHECK(counts_of(labelled).euler_region == 2);
  }
  // Set to lie behind, or with ends just inside, it passes behind the body.
  Drawing behind = drawing_of({body, limb});
  behind.strokes[1].data["behind"] = "body";
  CHECK(overlaps_of(label_in_view(behind)) == Overlaps{{"body", "limb"}});
  Drawing overshot = drawing_of({body, limb_stroke(97)});
  CHECK(overlaps_of(label_in_view(overshot)) == Overlaps{{"body", "limb"}});
}

TEST_CASE("lines whose order nothing shows bound nothing") {
  Drawing open = drawing_of(
      {stroke_of("left", circle_outline({-260, 0}, 70), true), stroke_of("right", circle_outline({260, 0}, 70), true),
       stroke_of("down", straight({-200, 20}, {200, -20})), stroke_of("up", straight({-200, -20}, {200, 20}))});
  const LabelledDrawing limbs = label_in_view(open);
  CHECK_FALSE(has_errors(limbs.findings));

  std::vector<Vec2> eight;
  for (int i = 0; i < 200; ++i) {
    const double t = 2 * std::numbers::pi * (i + 0.3) / 200;
    eight.emplace_back(200 * std::sin(t), 100 * std::sin(2 * t));
  }
  Drawing twisted = drawing_of({stroke_of("eight", eight, true)});
  const LabelledDrawing lobes = label_in_view(twisted);
  CHECK_FALSE(has_errors(lobes.findings));
}

TEST_CASE("a bar behind a ring is seen in its hole, one before the ring covers both outlines") {
  const std::vector<Vec2> bar{{-300, -20}, {300, -20}, {300, 20}, {-300, 20}};
  const std::vector<Stroke> ring{stroke_of("ring", circle_outline({0, 0}, 150), true),
                                 stroke_of("hole", circle_outline({0, 0}, 100), true)};
  Drawing behind = drawing_of({stroke_of("bar", bar, true), ring[0], ring[1]});
  const LabelledDrawing threaded = label_in_view(behind);
  CHECK(overlaps_of(threaded) == Overlaps{{"ring", "bar"}, {"ring", "bar"}});
  CHECK(counts_of(threaded).objects == 2);
  CHECK(counts_of(threaded).euler_region == 1);
  Drawing before = drawing_of({ring[0], ring[1], stroke_of("bar", bar, true)});
  const LabelledDrawing laid = label_in_view(before);
  CHECK(overlaps_of(laid) == Overlaps{{"bar", "ring"}, {"bar", "ring"}});
  CHECK(counts_of(laid).euler_region == 1);
  // A hub on a wheel is no hole: what passes behind the wheel passes behind the hub.
  Drawing wheel = behind;
  wheel.strokes[2] = stroke_of("hub", circle_outline({0, 0}, 40), true);
  CHECK(counts_of(label_in_view(wheel)).objects == 3);
}

TEST_CASE("a shape that others cover completely is not lost without a word") {
  Drawing drawing = drawing_of({stroke_of("small", ellipse({0, 0}, 60, 20, 0), true),
                                stroke_of("left", circle_outline({-60, 3}, 80), true),
                                stroke_of("right", circle_outline({60, -2}, 80), true)});
  const LabelledDrawing labelled = label_in_view(drawing);
  const bool named = std::ranges::count(labelled.findings, "W_LEFT_OUT", &Finding::code) > 0;
  CHECK((named || labelled.kinds.front() == silhouette::StrokeKind::Detail));
}
