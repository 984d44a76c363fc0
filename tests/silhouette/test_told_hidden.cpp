// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/stroke_data.h"
#include "silhouette/labelled_counts.h"
#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::test;

namespace {

Stroke hidden(const std::string& id, const std::vector<Vec2>& points) {
  Stroke stroke = stroke_of(id, points);
  stroke.data[silhouette::kind_key] = silhouette::to_string(silhouette::StrokeKind::Hidden);
  return stroke;
}

/// Two capsules on both sides of a disc, in line with one another: read as one stick behind it.
Drawing stick_behind_disc() {
  std::vector<LayeredPart> parts;
  parts.push_back({tube_outline(bar({-320, -60}, {320, 60}, 14, [](double) { return 0.0; })), 0});
  parts.push_back({circle_outline({0, 0}, 130), 1});
  return layered_sketch(parts).drawing;
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

TEST_CASE("a hidden stroke is the contour between the two ends that are nearest") {
  const Drawing plain = stick_behind_disc();
  REQUIRE(counts_of(label_quietly(plain)).objects == 2);
  Drawing told = plain;
  const std::vector<Vec2> left = ends_beside(plain, -1);
  REQUIRE(left.size() == 2);
  // The left piece is a limb of its own, as long as its cap says; drawn a little carelessly.
  const Vec2 tip(-60, 0.5 * (left[0].y() + left[1].y()) + 12);
  told.strokes.push_back(
      hidden("cap", {left[0] + Vec2(3, 2), tip + Vec2(-10, -13), tip, tip + Vec2(-10, 13), left[1] + Vec2(-2, 3)}));
  for (const bool reversed : {false, true}) {
    const silhouette::LabelledDrawing labelled = label_quietly(reversed ? reversed_strokes(told) : told);
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

TEST_CASE("hidden strokes that lead from no end to another are told by name, and the rest is read without them") {
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
