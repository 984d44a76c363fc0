// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"
#include "silhouette/labelled_counts.h"
#include "support/sample_count.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_generator.h"

namespace croquis::silhouette {
namespace {

using namespace croquis::test;

/// Objects, contours, panels and Euler numbers as in the sketch, and no error.
bool read_as_meant(const Drawing& drawing, const SketchTruth& truth) {
  try {
    const LabelledDrawing labelled = label_quietly(drawing, Options::of(Preset::Tablet));
    const LabelledCounts found = counts_of(labelled);
    const LabelledCounts meant = counts_of(truth);
    return !has_errors(labelled.findings) && found.objects == meant.objects && found.contours == meant.contours &&
           found.panels == meant.panels && found.euler_region == meant.euler_region;
  } catch (const Error&) {
    return false;
  }
}

/// Percent of the sketches of `scripts/bench silhouette-hand` that are read as meant, a few seeds each.
int percent_read(const HandOptions& hand, std::uint64_t first_seed) {
  int right = 0;
  int drawings = 0;
  for (const NamedSketch& sketch : hand_sketches()) {
    for (int i = 0; i < sample_count(4, 40); ++i, ++drawings) {
      const std::uint64_t seed = first_seed + static_cast<std::uint64_t>(i);
      right += read_as_meant(drawn_by_hand(sketch.sketch, seed, hand), sketch.sketch.truth);
    }
  }
  return 100 * right / drawings;
}

bool reports(const Drawing& drawing, const std::string& code) {
  return std::ranges::count(findings_of(drawing, Options::of(Preset::Tablet)), code, &Finding::code) > 0;
}

/// A circle drawn from an angle on over a share of its circumference, its end aside by a share of it.
Stroke loop(const Vec2& centre, double radius, double share, double aside) {
  std::vector<Vec2> points;
  const int count = 240;
  for (int i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / count;
    const double angle = 0.7 + 2 * std::numbers::pi * share * t;
    const double out = radius + aside * 2 * std::numbers::pi * radius * std::pow(std::max(0.0, 3 * t - 2), 2);
    points.emplace_back(centre + out * Vec2(std::cos(angle), std::sin(angle)));
  }
  return stroke_of("loop", points);
}

/// A line with the samples moved aside by a function of the way along it.
template <typename Aside>
Stroke beside(const std::string& id, Aside aside) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 300; ++i) points.emplace_back(100 + 2.5 * i, 300 + 40 * std::sin(0.02 * i) + aside(i));
  return stroke_of(id, points);
}

/// The share of a stroke that lies in none of the contours.
double share_outside(const Stroke& stroke, const LabelledDrawing& labelled) {
  const auto is_within = [&](const StrokeSample& sample) {
    for (const LabelledFigure& figure : labelled.figures) {
      for (Index contour = 0; contour < figure.contours.size(); ++contour) {
        if (winding_number(contour_points(figure, contour), sample.position) % 2 != 0) return true;
      }
    }
    return false;
  };
  return 1 - static_cast<double>(std::ranges::count_if(stroke.samples, is_within)) /
                 static_cast<double>(stroke.samples.size());
}

}  // namespace

TEST_CASE("outlines are closed that miss themselves by up to 5 % of their length or 3 % aside") {
  for (const double share : {0.95, 0.97, 1.0, 1.03, 1.05}) {
    for (const double aside : {-0.03, -0.015, 0.0, 0.015, 0.03}) {
      for (const double radius : {300.0, 3.0}) {
        INFO("drawn over " << share << ", aside by " << aside << ", radius " << radius);
        CHECK(read_as_meant(drawing_of({loop({0, 0}, radius, share, aside)}), circle_sketch().truth));
      }
    }
  }
}

TEST_CASE("an outline that goes once more over its beginning is closed where it began") {
  for (const double share : {1.08, 1.15, 1.3, 1.45}) {
    for (const double aside : {-0.003, 0.0, 0.003}) {
      INFO("drawn over " << share << ", aside by " << aside);
      Stroke outline = loop({0, 0}, 300, share, aside);
      CHECK(read_as_meant(drawing_of({outline}), circle_sketch().truth));
      outline.data["kind"] = "contour";  // what is said of it changes nothing
      CHECK(read_as_meant(drawing_of({outline}), circle_sketch().truth));
    }
  }
}

TEST_CASE("an outline that lacks up to a third is closed with a word, half of one is a limb") {
  const auto read = [](double share) {
    return label_quietly(drawing_of({loop({0, 0}, 300, share, 0)}), Options::of(Preset::Tablet));
  };
  for (const double share : {0.78, 0.85, 0.9}) {
    INFO(share);
    const LabelledDrawing closed = read(share);
    REQUIRE(closed.findings.size() == 1);
    CHECK(closed.findings.front().code == "W_GAP");
    CHECK(closed.kinds.front() == silhouette::StrokeKind::Contour);
  }
  CHECK(read(0.5).kinds.front() == silhouette::StrokeKind::Tube);
}

TEST_CASE("drawings whose ends miss, whose loops stay open, or that are in pieces, are read as they were meant") {
  HandOptions ends;
  ends.end_miss = 0.03;
  CHECK(percent_read(ends, 9001) >= 95);
  HandOptions loops;
  loops.closing = 0.05;
  loops.aside = 0.03;
  CHECK(percent_read(loops, 9101) >= 95);
  HandOptions pieces;
  pieces.pieces = 4;
  pieces.piece_gap = 0.015;
  CHECK(percent_read(pieces, 9201) >= 90);
  HandOptions retraced;
  retraced.pieces = 2;
  retraced.retrace = 0.15;
  CHECK(percent_read(retraced, 9251) >= 85);
}

TEST_CASE("drawings of an unsteady hand are read as they were meant") {
  HandOptions jitter;
  jitter.jitter = 0.01;
  jitter.closing = 0.02;
  jitter.aside = 0.01;
  CHECK(percent_read(jitter, 9301) >= 95);
  jitter.jitter = 0.02;
  CHECK(percent_read(jitter, 9401) >= 80);
}

TEST_CASE("outlines that an unsteady hand lets overlap a little lie beside one another") {
  HandOptions hand;
  hand.jitter = 0.02;
  for (const double overlap : {0.0, 8.0}) {
    const std::vector<Vec2> left = circle_outline({-150 + overlap / 2, 0}, 150);
    const std::vector<Vec2> right = circle_outline({150 - overlap / 2, 0}, 150);
    Sketch sketch;
    sketch.truth.outlines = {{left, {}, 0}, {right, {}, 1}};
    sketch.drawing.strokes = {stroke_of("left", left, true), stroke_of("right", right, true)};
    for (std::uint64_t seed = 9601; seed < 9613; ++seed) {
      INFO("overlap " << overlap << ", seed " << seed);
      const LabelledDrawing labelled = label_quietly(drawn_by_hand(sketch, seed, hand), Options::of(Preset::Tablet));
      CHECK_FALSE(has_errors(labelled.findings));
      CHECK(labelled.crossings.empty());
    }
    // Drawn exactly, an overlap is meant.
    if (overlap > 0) CHECK(label_quietly(sketch.drawing, Options::of(Preset::Tablet)).crossings.size() == 1);
  }
}

TEST_CASE("the two sides of something thin that an unsteady hand let cross are led beside one another") {
  DrawingScale scale;
  scale.step = 5;
  // A long shape whose width changes its sign between the places.
  const auto shape = [](const std::vector<double>& places) {
    const auto width = [&](double x) {
      double product = 30 * std::sin(std::numbers::pi * x / 600);
      for (const double place : places) product *= std::tanh((x - place) / 60);
      return product;
    };
    CleanLine line;
    line.closed = true;
    for (int i = 0; i <= 120; ++i) line.points.emplace_back(5 * i, width(5 * i));
    for (int i = 119; i > 0; --i) line.points.emplace_back(5 * i - 1, -width(5 * i - 1));
    line.stroke.assign(line.points.size(), 0);
    line.strokes = {0};
    line.raw = line.points;
    line.size = size_of(line.points, true);
    return line;
  };
  const auto crossings = [](const CleanLine& line) {
    int count = 0;
    const std::size_t n = line.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        count += segments_cross(line.points[i], line.points[(i + 1) % n], line.points[k], line.points[(k + 1) % n]);
      }
    }
    return count;
  };
  for (const std::vector<double>& places : {std::vector<double>{151}, {151, 402}, {151, 302, 453}}) {
    INFO(places.size() << " places");
    CleanLine line = shape(places);
    REQUIRE(crossings(line) == static_cast<int>(places.size()));
    CleanLine exact = line;
    scale.reach_share = 0;
    CHECK(uncross(exact, scale).empty());
    scale.reach_share = 0.04;
    CHECK(uncross(line, scale).size() == places.size());
    CHECK(crossings(line) == 0);
    CHECK(line.points.size() == exact.points.size());
    CHECK(line.raw == line.points);
  }
  // An end that crosses its own line passes behind it.
  CleanLine open;
  for (int i = 0; i <= 120; ++i) {
    const double angle = 2 * std::numbers::pi * i / 110;
    open.points.emplace_back((100 - 0.3 * i) * Vec2(std::cos(angle), std::sin(angle)));
  }
  open.points.emplace_back(110, 40);
  open.stroke.assign(open.points.size(), 0);
  open.raw = open.points;
  open.size = size_of(open.points, false);
  REQUIRE(crossings(open) > 0);
  CHECK(uncross(open, scale).empty());
}

TEST_CASE("ends that run side by side are those of a strand, not of an outline that misses itself") {
  std::vector<Vec2> points;
  for (int i = 0; i <= 140; ++i) points.emplace_back(700 - 5 * i, 20);
  for (int i = 1; i < 20; ++i) {
    const double angle = std::numbers::pi * (0.5 + i / 20.0);
    points.emplace_back(20 * std::cos(angle), 20 * std::sin(angle));
  }
  for (int i = 0; i <= 140; ++i) points.emplace_back(5 * i, -20);
  // What it passes behind is missed by 4 %.
  const Stroke strand = stroke_of("strand", points);
  const Stroke front = stroke_of("front", circle_outline({860, 0}, 130), true);
  CHECK_FALSE(reports(drawing_of({strand, front}), "W_GAP"));
}

TEST_CASE("where an unsteady line ends, its direction is that of a longer piece") {
  DrawingScale scale;
  const double wave = 60;
  CleanLine line;
  for (int i = 0; i <= 96; ++i) {
    const double x = 5.0 * i;
    line.points.emplace_back(x, 8 * std::sin(2 * std::numbers::pi * x / wave));
  }
  line.size = size_of(line.points, false);
  const auto misdirected = [&] { return std::acos(std::min(1.0, end_direction(line, false, scale).x())); };
  scale.jitter = 0;
  CHECK(misdirected() > 0.5);
  scale.jitter = 1;
  CHECK(misdirected() < 0.2);
  // Drawn exactly, a bend is followed.
  for (Vec2& point : line.points) point.y() = 200 - std::sqrt(200 * 200 - std::pow(point.x() / 3, 2));
  scale.jitter = 0;
  const Vec2 end = line.points.back();
  const Vec2 along = Vec2(200 - end.y(), end.x() / 3 / 3).normalized();
  CHECK(cross(along, end_direction(line, false, scale)) == Approx(0).margin(0.01));
}

TEST_CASE("many small things on one sheet are read like one of them") {
  const HandOptions hand{0.004, 0.2, 0.02, 0, 0, 1, 0, false};
  for (const int rings : {2, 12, 24}) {
    INFO(rings << " rings");
    const Sketch chain = chain_sketch(rings);
    CHECK(read_as_meant(chain.drawing, chain.truth));
    CHECK(read_as_meant(drawn_by_hand(chain, 5, hand), chain.truth));
  }
  Sketch sheet;
  for (int i = 0; i < 24; ++i) {
    const Sketch pair = translated(linked_rings_sketch(), Vec2(1000.0 * (i % 6), 700.0 * (i / 6)));
    const Drawing drawn = drawn_by_hand(pair, static_cast<std::uint64_t>(i), hand);
    for (Stroke stroke : drawn.strokes) {
      stroke.id += "-" + std::to_string(i);
      sheet.drawing.strokes.push_back(std::move(stroke));
    }
  }
  const LabelledDrawing labelled = label_quietly(sheet.drawing, Options::of(Preset::Tablet));
  CHECK_FALSE(has_errors(labelled.findings));
  CHECK(counts_of(labelled).objects == 48);
  CHECK(counts_of(labelled).euler_region == 0);
}

TEST_CASE("an end near its own start, where the stroke passes behind itself, isn't joined to it") {
  HandOptions hand;
  hand.jitter = 0.01;
  for (int seed = 1; seed <= sample_count(8, 60); ++seed) {
    INFO("seed " << seed);
    const Sketch snake = snake_sketch();
    CHECK(read_as_meant(drawn_by_hand(snake, static_cast<std::uint64_t>(seed), hand), snake.truth));
  }
}

TEST_CASE("lines drawn over again are named, parallel strands are not") {
  const auto straight = [](int) { return 0.0; };
  const Stroke frame = stroke_of("frame", circle_outline({450, 300}, 440), true);
  for (const double wobble : {0.0, 1.0, 2.5}) {
    INFO("over-traced with " << wobble);
    const auto over = [&](int i) { return wobble * std::sin(0.11 * i + 1); };
    CHECK(reports(drawing_of({frame, beside("first", straight), beside("again", over)}), "W_DOUBLE"));
  }
  for (const double apart : {3.0, 4.0, 5.0}) {
    for (const double wobble : {0.0, 0.5, 1.0}) {
      INFO("strands " << apart << " apart, with " << wobble);
      const auto strand = [&](int i) { return apart + wobble * std::sin(0.11 * i + 1); };
      CHECK_FALSE(reports(drawing_of({frame, beside("first", straight), beside("second", strand)}), "W_DOUBLE"));
    }
  }
}

TEST_CASE("no line that lies beside its solid is taken for a detail of it") {
  HandOptions hand;
  hand.jitter = 0.01;
  for (const Character& character : all_characters()) {
    for (int seed = 0; seed < sample_count(2, 20); ++seed) {
      const Drawing drawing =
          drawn_by_hand(character_sketch(character), 91001 + static_cast<std::uint64_t>(seed), hand);
      const LabelledDrawing labelled = label_quietly(drawing);
      INFO(character.name << " " << seed);
      for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
        if (labelled.kinds[s] != StrokeKind::Detail) continue;
        INFO(drawing.strokes[s].id);
        CHECK(share_outside(drawing.strokes[s], labelled) < 0.6);
      }
    }
  }
}

}  // namespace croquis::silhouette
