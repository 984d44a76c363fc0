// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"
#include "croquis/tools/silhouette/stroke_edit.h"
#include "tools/pointer/segment_distance.h"
#include "tools/strokes/drawn_strokes.h"

namespace croquis {
namespace {

using Ids = std::vector<std::string>;

bool same(const StrokeSample& a, const StrokeSample& b) {
  return a.position == b.position && a.pressure == b.pressure && a.tilt == b.tilt && a.time == b.time;
}

bool same(const Stroke& a, const Stroke& b) {
  return a.id == b.id && a.closed == b.closed && a.data == b.data && a.object == b.object && a.line == b.line &&
         std::equal(a.samples.begin(), a.samples.end(), b.samples.begin(), b.samples.end(),
                    [](const auto& x, const auto& y) { return same(x, y); });
}

/// A ring, a wave and a line, each through many samples.
Drawing sketch() {
  Drawing drawing;
  drawing.strokes.push_back(test::circle("ring", {0, 0}, 100, 240));
  for (const test::DrawnCurve& curve : test::drawn_curves()) {
    if (curve.name == "wave") drawing.strokes.push_back(test::sampled(curve, "wave"));
    if (curve.name == "square") drawing.strokes.push_back(test::sampled(curve, "stroke 7"));
  }
  for (Stroke& stroke : drawing.strokes) {
    stroke.data["scale"] = "1";
    for (StrokeSample& sample : stroke.samples)
      if (stroke.id == "wave") sample.position.y() += 400;  // its ends rest on nothing
  }
  return drawing;
}

std::vector<StrokeSample> through(const std::vector<Vec2>& places) { return test::stroke_through(places, "").samples; }

std::vector<Vec2> straight(const Vec2& a, const Vec2& b, int steps = 60) {
  std::vector<Vec2> places;
  for (int i = 0; i <= steps; ++i) places.push_back(a + i / double(steps) * (b - a));
  return places;
}

/// Along a circle, its radius changed by `bulge` in the middle.
std::vector<Vec2> arc(double radius, double from, double to, double bulge, const Vec2& centre = {0, 0}) {
  std::vector<Vec2> places;
  for (int i = 0; i <= 80; ++i) {
    const double t = i / 80.0;
    const double angle = from + t * (to - from);
    const double lift = std::pow(std::sin(3.141592653589793 * std::clamp(2 * t - 0.5, 0.0, 1.0)), 2) * bulge;
    places.push_back(centre + (radius + lift) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return places;
}

double largest_gap(const Stroke& stroke) {
  double gap = 0;
  for (std::size_t i = 1; i < stroke.samples.size(); ++i)
    gap = std::max(gap, (stroke.samples[i].position - stroke.samples[i - 1].position).norm());
  if (stroke.closed) gap = std::max(gap, (stroke.samples.back().position - stroke.samples.front().position).norm());
  return gap;
}

TEST_CASE("a drawn stroke gets a name of its own, its scale, and times from zero; a loop is closed") {
  DrawOptions options;
  options.units_per_pixel = 0.5;
  std::vector<StrokeSample> samples = through(straight({300, 0}, {300, 90}));
  for (StrokeSample& sample : samples) sample.time += 1e6;
  const Drawing before = sketch();
  const DrawingEdit edit = draw_stroke(before, samples, options);
  CHECK(edit.added == Ids{"stroke 8"});
  REQUIRE(edit.drawing.strokes.size() == before.strokes.size() + 1);
  const Stroke& stroke = edit.drawing.strokes.back();
  CHECK(stroke.samples.front().time == 0);
  CHECK(stroke.samples.back().time == Approx(0.2));
  CHECK(!stroke.closed);
  CHECK(drawn_scale(edit.drawing, stroke) == 0.5);
  for (std::size_t i = 0; i < before.strokes.size(); ++i) CHECK(same(before.strokes[i], edit.drawing.strokes[i]));

  const DrawingEdit loop = draw_stroke({}, through(arc(50, 0, 6.2831853, 0)));
  REQUIRE(loop.added == Ids{"stroke 1"});
  CHECK(loop.drawing.strokes[0].closed);
  CHECK(draw_stroke(loop.drawing, samples).added == Ids{"stroke 2"});
}

TEST_CASE("a loop that stops short of its beginning, or runs past it on any side, closes without crossing or folding") {
  test::Random random(4);
  for (const double past : {-7.0, -4.0, 0.0, 3.0, 6.0, 9.0, 11.0, 20.0, 30.0}) {
    for (const double aside : {-9.0, -4.0, 0.0, 4.0, 9.0}) {
      for (const double noise : {0.0, 0.3}) {
        INFO("past by " << past << ", aside by " << aside << ", jitter " << noise);
        std::vector<Vec2> places;
        for (int i = 0; i <= 240; ++i) {
          const double angle = i / 240.0 * (6.283185307 + past / 150);
          places.push_back((150 + aside * i / 240.0) * Vec2(std::cos(angle), std::sin(angle)) +
                           test::jitter(random, noise));
        }
        const Stroke loop = draw_stroke({}, through(places)).drawing.strokes.front();
        REQUIRE(loop.closed);
        CHECK(loop.samples.size() > 220 - static_cast<std::size_t>(std::max(0.0, past) / 4));
        std::vector<Vec2> kept;
        for (const StrokeSample& sample : loop.samples) kept.push_back(sample.position);
        const std::size_t count = kept.size();
        for (std::size_t a = 0; a < count; ++a) {
          for (std::size_t b = a + 2; b < count; ++b) {
            if (a == 0 && b + 1 == count) continue;
            const double crosses = segment_distance(kept[a], kept[a + 1], kept[b], kept[(b + 1) % count]);
            REQUIRE(crosses > 0);
          }
        }
        const Vec2 step = kept.front() - kept.back();
        const Vec2 ahead = left_of(kept.front().normalized());
        if (step.norm() > 2) CHECK(step.dot(ahead) > 0.5 * step.norm());
        CHECK(step.norm() < 30);
      }
    }
  }
}

TEST_CASE("a loop closed at a corner keeps the corner, and what overshoots it is cut off") {
  std::vector<Vec2> places;
  for (const auto& side : {straight({0, 0}, {200, 0}), straight({200, 0}, {200, 200}), straight({200, 200}, {0, 200}),
                           straight({3, 200}, {3, -9})})
    places.insert(places.end(), side.begin(), side.end());
  const Stroke loop = draw_stroke({}, through(places)).drawing.strokes.front();
  CHECK(loop.closed);
  for (const StrokeSample& sample : loop.samples) CHECK(sample.position.y() > -4);
  CHECK(loop.samples.size() > places.size() - 12);
}

TEST_CASE("a stroke's scale is the one it was drawn at, else a thousandth of the drawing's diagonal") {
  Drawing drawing;
  drawing.strokes = {test::stroke_through({{0, 0}, {300, 400}}, "a"), test::stroke_through({{0, 0}}, "b")};
  CHECK(drawn_scale(drawing, drawing.strokes[0]) == Approx(0.5));
  for (const char* nonsense : {"", "-1", "0", "pear", "nan", "1x"}) {
    drawing.strokes[1].data["scale"] = nonsense;
    CHECK(drawn_scale(drawing, drawing.strokes[1]) == Approx(0.5));
  }
  drawing.strokes[1].data["scale"] = "0.25";
  CHECK(drawn_scale(drawing, drawing.strokes[1]) == 0.25);
}

TEST_CASE("dragging an anchor bends up to its neighbours and leaves everything beyond as it was") {
  const Drawing before = sketch();
  for (const Stroke& stroke : before.strokes) {
    const StrokeFit fit = fit_in_drawing(before, stroke);
    const std::size_t count = fit.anchors.size();
    for (std::size_t anchor = 0; anchor < count; ++anchor) {
      INFO(stroke.id << " anchor " << anchor << " of " << count);
      const Vec2 by(7, -3);
      const DrawingEdit edit = drag_anchor(before, stroke.id, fit, anchor, by);
      CHECK(edit.changed == Ids{stroke.id});
      const Stroke& after = *find_stroke(edit.drawing, stroke.id);
      REQUIRE(after.samples.size() == stroke.samples.size());
      const std::size_t total = stroke.samples.size();
      const std::size_t low =
          anchor == 0 ? (fit.closed ? fit.anchors[count - 1].sample : 0) : fit.anchors[anchor - 1].sample;
      const std::size_t high =
          anchor + 1 == count ? (fit.closed ? fit.anchors[0].sample : total - 1) : fit.anchors[anchor + 1].sample;
      const std::size_t centre = fit.anchors[anchor].sample;
      double previous = 0;
      for (std::size_t step = 0; step < total; ++step) {
        const std::size_t i = (low + step) % total;
        const Vec2 shift = after.samples[i].position - stroke.samples[i].position;
        const bool inside = low < high ? i > low && i < high : i > low || i < high;
        if (i == centre) CHECK((shift - by).norm() < 1e-9);
        if (i != centre && !inside) CHECK(shift.norm() == 0);
        const double share = shift.dot(by) / by.squaredNorm();
        CHECK(share >= -1e-12);
        CHECK(share <= 1 + 1e-12);
        if (step > 0 && (fit.closed || i > 0)) CHECK(std::abs(share - previous) < 0.35);  // no tear between neighbours
        previous = share;
        CHECK(after.samples[i].pressure == stroke.samples[i].pressure);
        CHECK(after.samples[i].time == stroke.samples[i].time);
      }
      for (std::size_t k = 0; k < before.strokes.size(); ++k) {
        if (before.strokes[k].id != stroke.id) CHECK(same(before.strokes[k], edit.drawing.strokes[k]));
      }
    }
  }
}

TEST_CASE("a drag and its opposite give the stroke back") {
  const Drawing before = sketch();
  const StrokeFit fit = fit_in_drawing(before, before.strokes[0]);
  const DrawingEdit there = drag_anchor(before, "ring", fit, 1, {5, 9});
  // The way back must use the same falloff, so it is taken along the bent stroke only for a short drag.
  const DrawingEdit back = drag_anchor(there.drawing, "ring", fit, 1, {-5, -9});
  double largest = 0;
  for (std::size_t i = 0; i < before.strokes[0].samples.size(); ++i)
    largest =
        std::max(largest, (back.drawing.strokes[0].samples[i].position - before.strokes[0].samples[i].position).norm());
  CHECK(largest < 1);
}

TEST_CASE("samples of a pen held still move together") {
  Drawing drawing;
  drawing.strokes = {test::stroke_through({{0, 0}, {50, 50}, {50, 50}, {50, 50}, {100, 0}}, "hook")};
  drawing.strokes[0].data["scale"] = "1";
  const StrokeFit fit = fit_in_drawing(drawing, drawing.strokes[0]);
  for (std::size_t anchor = 0; anchor < fit.anchors.size(); ++anchor) {
    const Stroke after = drag_anchor(drawing, "hook", fit, anchor, {3, 3}).drawing.strokes[0];
    CHECK(after.samples[1].position == after.samples[2].position);
    CHECK(after.samples[1].position == after.samples[3].position);
  }
}

TEST_CASE("dragging what isn't there is refused by name") {
  const Drawing drawing = sketch();
  const StrokeFit fit = fit_in_drawing(drawing, drawing.strokes[0]);
  CHECK_THROWS_AS(drag_anchor(drawing, "nobody", fit, 0, {1, 1}), Error);
  CHECK_THROWS_AS(drag_anchor(drawing, "ring", fit, fit.anchors.size(), {1, 1}), Error);
}

TEST_CASE("moving and removing strokes touches only those named") {
  const Drawing before = sketch();
  const DrawingEdit moved = move_strokes(before, {"wave", "nobody", "ring"}, {3, 4});
  CHECK(moved.changed == Ids{"ring", "wave"});
  CHECK(same(moved.drawing.strokes[2], before.strokes[2]));
  for (std::size_t i = 0; i < before.strokes[0].samples.size(); ++i)
    CHECK((moved.drawing.strokes[0].samples[i].position - before.strokes[0].samples[i].position - Vec2(3, 4)).norm() <
          1e-12);
  const DrawingEdit removed = remove_strokes(before, {"wave", "nobody"});
  CHECK(removed.removed == Ids{"wave"});
  REQUIRE(removed.drawing.strokes.size() == 2);
  CHECK(same(removed.drawing.strokes[0], before.strokes[0]));
  CHECK(same(removed.drawing.strokes[1], before.strokes[2]));
  CHECK(!move_strokes(before, {"nobody"}, {1, 1}).any());
}

TEST_CASE("an outline stays open where something passes before it, or its ends rest on other lines") {
  Drawing drawing;
  drawing.strokes = {test::stroke_through(straight({-200, 4}, {200, 4}), "upper"),
                     test::stroke_through(straight({-200, -4}, {200, -4}), "lower")};
  std::vector<Vec2> ring;  // behind the thin stick, from one side to the other
  for (int i = 0; i <= 120; ++i) {
    const double angle = 0.06 + (2 * 3.14159265358979 - 0.12) * i / 120;
    ring.emplace_back(100 * std::cos(angle), 100 * std::sin(angle));
  }
  CHECK(!draw_stroke(drawing, through(ring)).drawing.strokes.back().closed);
  CHECK(draw_stroke({}, through(ring)).drawing.strokes.back().closed);

  Drawing body;
  body.strokes = {test::circle("body", {0, 0}, 150, 300)};
  std::vector<Vec2> ear{{-9, 149}, {-14, 200}, {-24, 250}, {0, 330}, {24, 250}, {14, 200}, {9, 149}};
  CHECK(!draw_stroke(body, through(ear)).drawing.strokes.back().closed);
}

TEST_CASE("a stroke drawn along part of an old one replaces it, in either direction, also across its beginning") {
  const Drawing before = sketch();
  struct Case {
    double from, to;
  };
  for (const Case& place :
       {Case{1.0, 2.2}, Case{2.2, 1.0}, Case{-0.7, 0.8}, Case{0.8, -0.7}, Case{3.0, 5.9}, Case{5.9, 3.0}}) {
    INFO(place.from << " to " << place.to);
    const DrawingEdit edit = draw_stroke(before, through(arc(103, place.from, place.to, 40)));
    CHECK(edit.added.empty());
    REQUIRE(edit.changed == Ids{"ring"});
    const Stroke& ring = *find_stroke(edit.drawing, "ring");
    CHECK(ring.closed);
    CHECK(largest_gap(ring) < 8);
    std::vector<Vec2> places;
    for (const StrokeSample& sample : ring.samples) places.push_back(sample.position);
    const double area = signed_area(places);
    CHECK(area > 3.14159 * 100 * 100 + 300);  // grown by the bulge, still counter-clockwise
    CHECK(area < 3.14159 * 145 * 145);
    const double middle = (place.from + place.to) / 2;
    const auto reached = [&](const Vec2& at) {
      return std::any_of(places.begin(), places.end(), [&](const Vec2& p) { return (p - at).norm() < 5; });
    };
    CHECK(reached(143 * Vec2(std::cos(middle), std::sin(middle))));
    CHECK(!reached(100 * Vec2(std::cos(middle), std::sin(middle))));
    std::size_t kept = 0;
    for (const StrokeSample& sample : before.strokes[0].samples)
      kept += static_cast<std::size_t>(
          std::any_of(ring.samples.begin(), ring.samples.end(), [&](const auto& s) { return same(s, sample); }));
    const double share = 1 - std::abs(place.to - place.from) / 6.2831853;
    CHECK(static_cast<double>(kept) == Approx(240 * share).margin(8));
    CHECK(same(*find_stroke(edit.drawing, "wave"), *find_stroke(before, "wave")));
    CHECK(std::is_sorted(ring.samples.begin(), ring.samples.end(),
                         [](const auto& a, const auto& b) { return a.time < b.time; }));
  }
}

TEST_CASE("an open stroke is redrawn in the middle and keeps both its ends") {
  Drawing drawing;
  drawing.strokes = {test::stroke_through(straight({0, 0}, {600, 0}, 300), "line")};
  std::vector<Vec2> bump;
  for (int i = 0; i <= 100; ++i) {
    const double t = i / 100.0;
    bump.push_back({150 + 300 * t, 4 + 80 * std::pow(std::sin(3.14159265 * std::clamp(1.5 * t - 0.25, 0.0, 1.0)), 2)});
  }
  for (const bool backward : {false, true}) {
    if (backward) std::reverse(bump.begin(), bump.end());
    const DrawingEdit edit = draw_stroke(drawing, through(bump));
    REQUIRE(edit.changed == Ids{"line"});
    const Stroke& line = edit.drawing.strokes[0];
    CHECK(!line.closed);
    CHECK(same(line.samples.front(), drawing.strokes[0].samples.front()));
    CHECK(same(line.samples.back(), drawing.strokes[0].samples.back()));
    CHECK(largest_gap(line) < 10);
    for (std::size_t i = 1; i < line.samples.size(); ++i)
      CHECK(line.samples[i].position.x() >= line.samples[i - 1].position.x() - 1e-9);
  }
}

TEST_CASE("strokes that only end on another one, or leave from it to the side, are strokes of their own") {
  const Drawing before = sketch();
  const std::vector<std::vector<Vec2>> lines = {
      straight({0, -100}, {0, 100}),    // across the ring, from rim to rim
      straight({100, 0}, {300, -200}),  // away from it
      arc(60, -2.2, 2.2, 0, {-90, 0}),  // a limb whose two ends meet the ring from outside
      straight({99, -5}, {99, 5}),      // a short tick along it
      arc(103, 1.0, 2.0, 0, {500, 0}),  // elsewhere
  };
  for (std::size_t k = 0; k < lines.size(); ++k) {
    INFO("line " << k);
    const DrawingEdit edit = draw_stroke(before, through(lines[k]));
    CHECK(edit.changed.empty());
    CHECK(edit.added.size() == 1);
  }
  DrawOptions never;
  never.redraws = false;
  CHECK(draw_stroke(before, through(arc(103, 1.0, 2.2, 40)), never).added.size() == 1);
}

TEST_CASE("of two old strokes the nearer one is redrawn") {
  Drawing drawing;
  drawing.strokes = {test::circle("far", {0, 0}, 108, 200), test::circle("near", {0, 0}, 101, 200)};
  CHECK(draw_stroke(drawing, through(arc(102, 1, 2.5, 20))).changed == Ids{"near"});
  std::reverse(drawing.strokes.begin(), drawing.strokes.end());
  CHECK(draw_stroke(drawing, through(arc(102, 1, 2.5, 20))).changed == Ids{"near"});
}

TEST_CASE("strokes without samples or with places that are not finite are refused") {
  CHECK_THROWS_AS(draw_stroke({}, {}), Error);
  CHECK_THROWS_AS(draw_stroke({}, through({{0, 0}, {INFINITY, 0}})), Error);
}

}  // namespace
}  // namespace croquis
