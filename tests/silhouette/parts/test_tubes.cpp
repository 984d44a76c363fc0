// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"
#include "croquis/silhouette/stroke_data.h"
#include "silhouette/labelled_counts.h"
#include "silhouette/solids.h"
#include "support/random.h"
#include "support/sample_count.h"

namespace croquis::silhouette {
namespace {

using namespace croquis::test;

constexpr double turn = 2 * std::numbers::pi;

/// A centre line, and what is known of its tube.
struct TubeSketch {
  std::string name;
  std::function<Vec2(double)> curve;  ///< from 0 to 1
  bool closed = true;
  double radius = 20;
  std::size_t crossings = 0;
};

std::function<Vec2(double)> torus_knot(int p, int q, double out) {
  return [=](double t) {
    const double r = 300 * (1 + out * std::cos(q * turn * t));
    return Vec2(r * std::cos(p * turn * t), r * std::sin(p * turn * t));
  };
}

std::vector<TubeSketch> tube_sketches() {
  const auto figure_eight = [](double t) {
    return Vec2((300 + 150 * std::cos(2 * turn * t)) * std::cos(3 * turn * t),
                (300 + 150 * std::cos(2 * turn * t)) * std::sin(3 * turn * t));
  };
  const auto spiral = [](double t) {
    return Vec2((60 + 340 * t) * std::cos(1.3 * turn * t), (60 + 340 * t) * std::sin(1.3 * turn * t));
  };
  const auto snake = [](double t) { return Vec2(200 * std::sin(turn * t), 800 * t); };
  return {{"trefoil", torus_knot(2, 3, 0.45), true, 34, 3},
          {"figure eight", figure_eight, true, 24, 4},
          {"(2,5) knot", torus_knot(2, 5, 0.4), true, 30, 5},
          {"spiral", spiral, false, 40, 0},
          {"S", snake, false, 45, 0}};
}

/// How a hand draws it.
struct Drawn {
  int samples = 200;
  double noise = 0;     ///< of the size of the curve: waves of a tenth to a third of it
  double pressure = 0;  ///< it varies by so much
  double angle = 0.3;   ///< that it is turned by
  double scale = 1;
};

Stroke tube_stroke(const TubeSketch& sketch, const Drawn& drawn, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec2> waves;
  for (int k = 0; k < 8; ++k) waves.emplace_back(random.between(-1, 1), random.between(-1, 1));
  const double phase = random.between(0, turn);
  Stroke stroke;
  stroke.id = "knot";
  stroke.closed = sketch.closed;
  for (int i = 0; i < drawn.samples; ++i) {
    const double t = i / static_cast<double>(sketch.closed ? drawn.samples : drawn.samples - 1);
    Vec2 place = sketch.curve(t);
    for (int k = 0; k < 8; ++k) {
      place +=
          600 * drawn.noise / 2 * std::sin(turn * (k + 5) * t + phase * (k + 1)) * waves[static_cast<std::size_t>(k)];
    }
    const double pressure = 0.5 + drawn.pressure * std::sin(3 * turn * t + phase);
    stroke.samples.push_back({drawn.scale * (Eigen::Rotation2Dd(drawn.angle) * place), pressure, Vec2::Zero(), 0});
  }
  stroke.data = {{"kind", "tube"}, {"radius", std::to_string(drawn.scale * sketch.radius)}};
  return stroke;
}

/// How often a line crosses itself, by looking at every pair of its segments.
std::size_t crossings_of(const Stroke& stroke) {
  const std::size_t count = stroke.samples.size(), segments = stroke.closed ? count : count - 1;
  std::size_t found = 0;
  for (std::size_t i = 0; i < segments; ++i) {
    for (std::size_t k = i + 1; k < segments; ++k) {
      const Vec2 &a = stroke.samples[i].position, &b = stroke.samples[(i + 1) % count].position;
      const Vec2 &c = stroke.samples[k].position, &d = stroke.samples[(k + 1) % count].position;
      const double first = crossing_fraction(a, b, c, d), second = crossing_fraction(c, d, a, b);
      if (first > 0 && first < 1 && second > 0 && second < 1) ++found;
    }
  }
  return found;
}

/// Whether the strand that the labelling has on top changes at every crossing along the centre line.
bool alternates(const Stroke& stroke, const LabelledDrawing& labelled) {
  std::vector<std::pair<double, bool>> visits;  // along the line; over
  std::vector<Vec2> line;
  for (const StrokeSample& sample : stroke.samples) line.push_back(sample.position);
  const auto count = static_cast<Index>(line.size());
  for (const TubeCrossing& crossing : labelled.tube_crossings) {
    const double first = nearest_on_line(line, crossing.at, 0, count);
    // The other visit lies farther along than the tube is thick.
    const Index away = count / 12;
    double second = 0, least = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < count; ++i) {
      const double apart = std::abs(i - first);
      if (std::min(apart, count - apart) < away) continue;
      const double distance = (line[i] - crossing.at).norm();
      if (distance < least) std::tie(second, least) = std::pair(i, distance);
    }
    visits.emplace_back(std::min(first, second), crossing.over);
    visits.emplace_back(std::max(first, second), !crossing.over);
  }
  std::ranges::sort(visits);
  return std::ranges::adjacent_find(visits, [](const auto& a, const auto& b) { return a.second == b.second; }) ==
         visits.end();
}

/// The share of places by which the tube, as discs along the drawn line, and the contours differ.
double silhouette_share(const TubeSketch& sketch, const Stroke& stroke, const LabelledDrawing& labelled, double scale) {
  const double radius = scale * sketch.radius;
  std::vector<std::vector<Vec2>> contours;
  std::vector<int> sides;
  for (const LabelledFigure& figure : labelled.figures) {
    for (Index c = 0; c < figure.contours.size(); ++c) {
      contours.push_back(contour_points(figure, c));
      sides.push_back(figure.contours[c].side);
    }
  }
  std::vector<Vec2> line;
  for (const StrokeSample& sample : stroke.samples) line.push_back(sample.position);
  const auto segments = static_cast<Index>(stroke.closed ? line.size() : line.size() - 1);
  double both = 0, either = 0;
  for (double x = -550; x < 900; x += 16) {
    for (double y = -550; y < 900; y += 16) {
      const Vec2 place(scale * x, scale * y);
      const bool drawn = (point_at(line, nearest_on_line(line, place, 0, segments)) - place).norm() < radius;
      int layers = 0;
      for (std::size_t c = 0; c < contours.size(); ++c) layers += sides[c] * winding_number(contours[c], place);
      both += drawn && layers > 0 ? 1 : 0;
      either += drawn || layers > 0 ? 1 : 0;
    }
  }
  return both / either;
}

/// The code and sentence of a tube that can't be made.
Finding refusal(Stroke stroke, const std::string& key, const std::string& value) {
  stroke.data[key] = value;
  const Findings findings = findings_of(drawing_of({stroke}));
  const auto found = std::ranges::find(findings, Severity::Error, &Finding::severity);
  INFO(key << " " << value);
  REQUIRE(found != findings.end());
  return *found;
}

TubeSketch ring(const Vec2& centre, double radius) {
  return {"ring", [=](double t) { return Vec2(centre + radius * Vec2(std::cos(turn * t), std::sin(turn * t))); }, true,
          30};
}

}  // namespace

TEST_CASE("a tube of a knot in one stroke keeps its crossings, which alternate", "[tubes]") {
  for (const TubeSketch& sketch : tube_sketches()) {
    for (const Drawn& drawn : {Drawn{}, Drawn{60}, Drawn{400, 0, 0, 2.1, 0.01}, Drawn{200, 0, 0, 1.1, 100},
                               Drawn{200, 0.02}, Drawn{200, 0, 0.3}}) {
      for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(sample_count(drawn.noise > 0 ? 4 : 1, 20));
           ++seed) {
        INFO(sketch.name << ", " << drawn.samples << " samples, noise " << drawn.noise << ", pressure "
                         << drawn.pressure << ", times " << drawn.scale << ", seed " << seed);
        const Stroke stroke = tube_stroke(sketch, drawn, seed);
        Drawn densely = drawn;
        densely.samples = 397;
        const Stroke dense = tube_stroke(sketch, densely, seed);
        const std::size_t crossings = crossings_of(dense);
        if (drawn.noise == 0) CHECK(crossings == sketch.crossings);
        const LabelledDrawing labelled = label_quietly(drawing_of({stroke}));
        CHECK_FALSE(has_errors(labelled.findings));
        const LabelledCounts counts = counts_of(labelled);
        const int pairs = static_cast<int>(crossings);
        CHECK(counts.contours == (sketch.closed ? 2 : 1));
        CHECK(counts.euler_region == (sketch.closed ? 0 : 1));
        CHECK(counts.crossings == 4 * pairs);
        CHECK(counts.hidden_arcs == 2 * pairs);
        CHECK(labelled.tube_crossings.size() == crossings);
        CHECK(labelled.figures.front().overlaps.size() == crossings);
        CHECK(alternates(dense, labelled));
        if (drawn.pressure == 0 && seed == 1) CHECK(silhouette_share(sketch, dense, labelled, drawn.scale) >= 0.97);
      }
    }
  }
}

TEST_CASE("tubes become sound solids: a torus where they are closed, a ball where they have ends", "[tubes]") {
  for (const TubeSketch& sketch : tube_sketches()) {
    INFO(sketch.name);
    const Solid solid = solid_of(drawing_of({tube_stroke(sketch, {150, 0.01, 0.2}, 3)}));
    check_sound(solid.mesh);
    CHECK(report_of(solid.mesh).euler_characteristic == (sketch.closed ? 0 : 2));
    CHECK(solid.diagnostics.silhouette_iou >= 0.97);
  }
}

TEST_CASE("words say which strand is over, and a swap turns one crossing round", "[tubes]") {
  const TubeSketch trefoil = tube_sketches().front();
  Stroke stroke = tube_stroke(trefoil, {}, 1);
  const auto over = [&](const Stroke& knot) {
    std::vector<bool> words;
    for (const TubeCrossing& crossing : label_quietly(drawing_of({knot})).tube_crossings) {
      if (words.size() <= crossing.word) words.resize(crossing.word + 1);
      words[crossing.word] = crossing.over;
    }
    return words;
  };
  CHECK(over(stroke) == std::vector<bool>{true, false, true});
  stroke.data["over"] = "auto, over,under";
  CHECK(over(stroke) == std::vector<bool>{true, true, false});
  stroke.data.erase("over");
  const LabelledDrawing before = label_quietly(drawing_of({stroke}));
  for (Index overlap = 0; overlap < 3; ++overlap) {
    const Drawing swapped = swap_overlaps(drawing_of({stroke}), before, {overlap});
    const LabelledDrawing after = label_quietly(swapped);
    REQUIRE(after.tube_crossings.size() == 3);
    const Index turned = before.figures.front().overlaps[overlap].tube_crossing;
    for (Index k = 0; k < 3; ++k) {
      CHECK((after.tube_crossings[k].over != before.tube_crossings[k].over) == (k == turned));
    }
    Options options;
    options.swaps = {overlap, overlap};
    CHECK(over(swap_overlaps(drawing_of({stroke}), before, options.swaps).strokes.front()) == over(stroke));
  }
  CHECK_THROWS_AS(swap_overlaps(drawing_of({stroke}), before, {3}), Error);
}

TEST_CASE("of two tubes the later one is in front, unless it is set behind; two rings are linked by words", "[tubes]") {
  Stroke first = tube_stroke(ring({0, 0}, 200), {}, 1), second = tube_stroke(ring({200, 30}, 200), {}, 1);
  second.id = "second";
  const auto upper = [&] {
    std::vector<Index> strokes;
    for (const LabelledFigure& figure : label_quietly(drawing_of({first, second})).figures) {
      for (const FigureOverlap& overlap : figure.overlaps)
        strokes.push_back(figure.objects[overlap.upper].strokes.front());
    }
    return strokes;
  };
  CHECK(upper() == std::vector<Index>{1, 1});
  second.data["behind"] = "knot";
  CHECK(upper() == std::vector<Index>{0, 0});
  second.data["over"] = "over,under";
  CHECK(upper() == std::vector<Index>{0, 1});
  const Solid solid = solid_of(drawing_of({first, second}));
  check_sound(solid.mesh);
  CHECK(report_of(solid.mesh).components == 2);
  CHECK(solid.diagnostics.minimum_gap > 0);
}

TEST_CASE("a tube across a body passes over it, behind it or through its hole as other lines do", "[tubes]") {
  Stroke body = tube_stroke(ring({0, 0}, 200), {}, 1);
  body.data.clear();
  body.id = "body";
  Stroke tube = tube_stroke({"bar", [](double t) { return Vec2(-500 + 1000 * t, 40.0); }, false, 30}, {}, 1);
  for (const bool behind : {false, true}) {
    if (behind) tube.data["behind"] = "all";
    const LabelledDrawing labelled = label_quietly(drawing_of({body, tube}));
    CHECK_FALSE(has_errors(labelled.findings));
    REQUIRE(labelled.figures.size() == 1);
    REQUIRE(labelled.figures.front().overlaps.size() == 1);
    const FigureOverlap& overlap = labelled.figures.front().overlaps.front();
    CHECK(labelled.figures.front().objects[overlap.upper].name == (behind ? "body" : "knot"));
    CHECK(overlap.crossings.size() == 4);
  }
}

TEST_CASE("ends are round, flat or pointed, and radii go along the line", "[tubes]") {
  const TubeSketch bar{"bar", [](double t) { return Vec2(1000 * t, 0.0); }, false, 50};
  const auto length = [&](const std::string& ends) {
    Stroke stroke = tube_stroke(bar, {50, 0, 0, 0}, 1);
    if (!ends.empty()) stroke.data["ends"] = ends;
    const std::vector<Vec2> outline = contour_points(label_quietly(drawing_of({stroke})).figures.front(), 0);
    const auto [low, high] = std::ranges::minmax(outline, {}, [](const Vec2& p) { return p.x(); });
    return high.x() - low.x();
  };
  CHECK(length("") == Approx(1100).epsilon(0.005));
  CHECK(length("round") == Approx(1100).epsilon(0.005));
  CHECK(length("flat") == Approx(1000).epsilon(0.005));
  CHECK(length("pointed") == Approx(1200).epsilon(0.005));
  Stroke cone = tube_stroke(bar, {50, 0, 0, 0}, 1);
  cone.data["radius"] = "20, 60,100";
  const LabelledDrawing labelled = label_quietly(drawing_of({cone}));
  for (const Vec2& place : contour_points(labelled.figures.front(), 0)) {
    if (place.x() < 200 || place.x() > 800) continue;
    CHECK(std::abs(place.y()) == Approx(20 + 80 * place.x() / 1000).margin(2));
  }
}

TEST_CASE("a tube that can't be made is named with what to do", "[tubes]") {
  const TubeSketch trefoil = tube_sketches().front();
  const Stroke stroke = tube_stroke(trefoil, {}, 1);
  for (const std::string radius : {"0", "-3", "nan", "inf", "", "wide", "3,,0", "1e400"}) {
    const Finding finding = refusal(stroke, "radius", radius);
    INFO(finding.message);
    CHECK(finding.code == "E_TUBE");
    CHECK(finding.message.find("\"knot\" has the radius") != std::string::npos);
    CHECK(strokes_named(finding) == std::vector<std::string>{"knot"});
  }
  std::string many = "5";
  for (int i = 0; i < 250; ++i) many += ",5";
  CHECK(refusal(stroke, "radius", many).message.find("251 radii for 200 points") != std::string::npos);
  CHECK(refusal(stroke, "ends", "square").message.find("write round, flat or pointed") != std::string::npos);
  CHECK(refusal(stroke, "over", "over,up").message.find("\"up\"") != std::string::npos);
  CHECK(refusal(stroke, "radius", "1e6").message.find("shorter than its radius") != std::string::npos);
  CHECK(refusal(stroke, "radius", "0.001").message.find("0.4 %") != std::string::npos);
  const Finding thick = refusal(stroke, "radius", "160");
  INFO(thick.message);
  CHECK(thick.code == "E_TUBE");
  CHECK(thick.message.find("side by side at (") != std::string::npos);
}

TEST_CASE("a limb of one line stays one where no radius is given", "[tubes]") {
  Stroke body = tube_stroke(ring({0, 0}, 200), {}, 1);
  body.data.clear();
  body.id = "body";
  Stroke leg = tube_stroke({"leg", [](double t) { return Vec2(30.0, -180 - 300 * t); }, false, 30}, {80, 0, 0, 0}, 1);
  leg.data.erase("radius");
  const LabelledDrawing labelled = label_quietly(drawing_of({body, leg}));
  CHECK(labelled.kinds[1] == StrokeKind::Tube);
  CHECK(labelled.tube_crossings.empty());
}

}  // namespace croquis::silhouette
