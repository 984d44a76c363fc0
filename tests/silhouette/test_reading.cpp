// SPDX-License-Identifier: GPL-3.0-or-later
// What every stroke of a drawing is taken for.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/reading/connections.h"
#include "algorithms/silhouette/reading/envelope.h"
#include "algorithms/silhouette/reading/reading_program.h"
#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"
#include "silhouette/labelled_counts.h"
#include "silhouette/solids.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_generator.h"
#include "support/sketches/sketch_modifiers.h"

using namespace croquis;
using namespace croquis::silhouette;
using namespace croquis::test;

namespace {

constexpr double pi = std::numbers::pi;

/// An animal as people draw one: a body of scallops that don't quite meet, a head whose outline stays open, legs and a
/// tail of one line, a face, fur, and a letter beside it. Ids say what each stroke is.
class PetDrawing {
 public:
  explicit PetDrawing(std::uint64_t seed) : random_(seed) {
    body();
    head();
    limbs();
    add("detail-mouth", arc({-175, 75}, 22, 200, 330));
    add("blob-eye", arc({-195, 105}, 9, 0, 362));
    scribble();
    add("ignored-letter", {{260, 240}, {260, 190}, {290, 190}});
  }

  Drawing take() { return std::move(drawing_); }

 private:
  std::vector<Vec2> arc(const Vec2& centre, double radius, double from, double to) {
    std::vector<Vec2> points;
    const int count = std::max(6, static_cast<int>(std::abs(to - from) / 8));
    for (int i = 0; i <= count; ++i) {
      const double angle = (from + (to - from) * i / count) * pi / 180;
      points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
  }

  void add(const std::string& id, std::vector<Vec2> points) {
    for (Vec2& point : points) point += Vec2(random_.between(-1.5, 1.5), random_.between(-1.5, 1.5));
    drawing_.strokes.push_back(stroke_of(id, points));
  }

  /// Three strokes, the ends up to 4 % of the drawing apart.
  void body() {
    for (int piece = 0; piece < 3; ++piece) {
      std::vector<Vec2> points;
      const double from = 120.0 * piece + random_.between(0, 4), to = 120.0 * (piece + 1) - random_.between(0, 4);
      for (double degrees = from; degrees <= to; degrees += 4) {
        const double scallops = 1 + 0.06 * std::abs(std::sin(degrees * pi / 60));
        points.emplace_back(150 * scallops * std::cos(degrees * pi / 180),
                            95 * scallops * std::sin(degrees * pi / 180));
      }
      add("contour-body-" + std::to_string(piece), points);
    }
  }

  void head() { add("contour-head", arc({-190, 90}, 55, random_.between(5, 15), random_.between(330, 345))); }

  void limbs() {
    for (int leg = 0; leg < 4; ++leg) {
      const double x = -90 + 60.0 * leg + random_.between(-8, 8);
      const double top = -95 * std::sqrt(1 - x * x / (150.0 * 150)) + random_.between(-4, 8);
      add("tube-leg-" + std::to_string(leg), {{x, top}, {x + 3, top - 45}, {x, -190}, {x - 16, -193}});
    }
    add("tube-tail", {{148, 20}, {175, 40}, {195, 35}, {205, 60}});
  }

  void scribble() {
    std::vector<Vec2> points;
    for (int i = 0; i < 120; ++i)
      points.emplace_back(-30 + 0.8 * i + 18 * std::cos(0.55 * i), 10 + 18 * std::sin(0.55 * i));
    add("scribble-fur", points);
  }

  Random random_;
  Drawing drawing_;
};

std::map<std::string, StrokeKind> kinds_by_id(const Drawing& drawing, const LabelledDrawing& labelled) {
  std::map<std::string, StrokeKind> kinds;
  for (std::size_t s = 0; s < drawing.strokes.size(); ++s) kinds[drawing.strokes[s].id] = labelled.kinds[s];
  return kinds;
}

LabelledDrawing read(const Drawing& drawing) { return label_quietly(drawing, Options::of(Preset::Tablet)); }

Solid solid_read(const Drawing& drawing) { return test::solid_of(drawing, Options::of(Preset::Tablet)); }

Stroke of_kind(Stroke stroke, StrokeKind kind) {
  stroke.data[kind_key] = to_string(kind);
  return stroke;
}

/// A body of half axes 200 and 90, whose belly is `belly(x)`.
double belly(double x) { return -90 * std::sqrt(1 - x * x / (200.0 * 200)); }

/// Points every three degrees; less than 360 degrees leave it open.
Stroke oval(const std::string& id, const Vec2& centre, const Vec2& axes, double degrees = 360) {
  std::vector<Vec2> points;
  for (double at = 0; at < degrees; at += 3) {
    points.emplace_back(centre + Vec2(axes.x() * std::cos(at * pi / 180), axes.y() * std::sin(at * pi / 180)));
  }
  return stroke_of(id, points, degrees == 360);
}

Drawing with_body(const Vec2& axes) { return drawing_of({oval("body", {0, 0}, axes)}); }

bool lies_within(const Envelope& envelope, const Vec2& place) {
  return std::ranges::any_of(envelope.regions,
                             [&](const EnclosedRegion& region) { return encloses(region.outline, place); });
}

/// Every stroke in pieces that begin where the last one ended.
Drawing in_pieces(const Drawing& drawing, std::size_t count) {
  Drawing result;
  for (const Stroke& stroke : drawing.strokes) {
    const std::size_t last = stroke.samples.size() - 1;
    for (std::size_t piece = 0; piece < count; ++piece) {
      Stroke part = stroke;
      part.closed = false;
      part.id += "-" + std::to_string(piece);
      part.samples.assign(stroke.samples.begin() + static_cast<std::ptrdiff_t>(last * piece / count),
                          stroke.samples.begin() + static_cast<std::ptrdiff_t>(last * (piece + 1) / count) + 1);
      if (stroke.closed && piece + 1 == count) part.samples.push_back(stroke.samples.front());
      result.strokes.push_back(std::move(part));
    }
  }
  return result;
}

}  // namespace

TEST_CASE("what people draw is taken for what it is") {
  int right = 0, all = 0;
  for (int seed = 1; seed <= sample_count(12, 100); ++seed) {
    const Drawing pet = PetDrawing(static_cast<std::uint64_t>(seed)).take();
    const LabelledDrawing labelled = read(pet);
    CHECK_FALSE(has_errors(labelled.findings));
    for (const auto& [id, kind] : kinds_by_id(pet, labelled)) {
      ++all;
      const bool meant = id.starts_with(to_string(kind));
      if (!meant) UNSCOPED_INFO("seed " << seed << ": " << id << " is read as " << to_string(kind));
      right += meant ? 1 : 0;
    }
  }
  CHECK(right >= 0.95 * all);
}

TEST_CASE("a reading is the same for any order, direction, place, size and turn of the strokes") {
  const Drawing pet = PetDrawing(1).take();
  const auto expected = kinds_by_id(pet, read(pet));
  const auto check = [&](const Drawing& changed) { CHECK(kinds_by_id(changed, read(changed)) == expected); };
  for (std::uint64_t seed = 1; seed <= 3; ++seed) check(shuffled_strokes(pet, seed));
  check(reversed_strokes(pet));
  Sketch sketch;
  sketch.drawing = pet;
  check(translated(sketch, {5000, -300}).drawing);
  check(scaled(sketch, 1e-3).drawing);
  check(scaled(sketch, 1e4).drawing);
  check(scaled(sketch, 1e20).drawing);
  for (const double turn : {0.4, 1.9}) check(rotated(sketch, turn).drawing);
  check(mirrored(sketch).drawing);
}

TEST_CASE("strokes in pieces, and drawn twice, make the same figure") {
  for (const auto& [name, sketch] : hand_sketches()) {
    INFO(name);
    const LabelledCounts meant = counts_of(sketch.truth);
    for (const std::size_t count : {std::size_t{2}, std::size_t{3}}) {
      const LabelledCounts found = counts_of(read(in_pieces(sketch.drawing, count)));
      CHECK(found.panels == meant.panels);
      CHECK(found.objects == meant.objects);
    }
    Drawing twice = sketch.drawing;
    Random random(7);
    for (const Stroke& stroke : sketch.drawing.strokes) {
      Stroke again = stroke;
      again.id += "-again";
      const Vec2 aside = 0.001 * diagonal(sketch.drawing) * Vec2(random.between(-1, 1), random.between(-1, 1));
      for (StrokeSample& sample : again.samples) sample.position += aside;
      twice.strokes.push_back(std::move(again));
    }
    const LabelledDrawing labelled = read(twice);
    CHECK(counts_of(labelled).panels == meant.panels);
    CHECK(std::ranges::count(labelled.findings, "W_DOUBLE", &Finding::code) ==
          static_cast<std::ptrdiff_t>(sketch.drawing.strokes.size()));
  }
}

TEST_CASE("the kind that a stroke is given holds") {
  for (const StrokeKind kind : {StrokeKind::Detail, StrokeKind::Tube, StrokeKind::Ignored, StrokeKind::Scribble}) {
    for (const std::string id : {"tube-leg-1", "detail-mouth", "tube-tail"}) {
      Drawing pet = PetDrawing(2).take();
      Stroke& stroke = *std::ranges::find(pet.strokes, id, &Stroke::id);
      stroke = of_kind(stroke, kind);
      INFO(id << " set to be " << to_string(kind));
      const LabelledDrawing labelled = read(pet);
      CHECK(kinds_by_id(pet, labelled).at(id) == kind);
      CHECK(std::ranges::none_of(labelled.findings, [&](const Finding& finding) {
        return finding.code == "W_LEFT_OUT" && finding.subjects.front().id == id;
      }));
    }
  }
}

TEST_CASE("what is set to be ignored isn't missed in the solid") {
  Drawing drawing =
      drawing_of({of_kind(oval("table", {0, 0}, {400, 400}), StrokeKind::Ignored), oval("mug", {0, 0}, {100, 100})});
  const Solid solid = solid_read(drawing);
  CHECK_FALSE(has_errors(solid.findings));
  CHECK(solid.objects.size() == 1);
  CHECK(solid.used == Approx(0.2));
}

TEST_CASE("where all lines are set to be ignored, one sentence says so") {
  Drawing drawing;
  for (const char* id : {"one", "other"}) {
    const std::vector<Vec2> square{{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    drawing.strokes.push_back(of_kind(stroke_of(id, square, true), StrokeKind::Ignored));
  }
  try {
    read(drawing);
    FAIL("there is no reading");
  } catch (const Error& error) {
    REQUIRE(error.findings().size() == 1);
    CHECK(error.findings().front().code == "E_NO_OUTLINE");
    CHECK_THAT(error.findings().front().message, Catch::Contains("ignored"));
  }
}

TEST_CASE("limbs of one line grow out of the body, and details lie on its front") {
  for (std::uint64_t seed = 3; seed < 5; ++seed) {
    const Drawing pet = PetDrawing(seed).take();
    const Solid solid = solid_read(pet);
    CHECK_FALSE(has_errors(solid.findings));
    const auto of_body =
        std::ranges::find_if(solid.shells, [&](const SolidShell& shell) { return shell.objects.size() > 1; });
    for (const Finding& finding : solid.findings) UNSCOPED_INFO(finding.code << " " << finding.message);
    REQUIRE(of_body != solid.shells.end());
    CHECK(of_body->objects.size() == 6);  // four legs and a tail
    CHECK(of_body->euler_mesh == 2);
    const TriangleTree tree = test::tree_of(solid.mesh);
    REQUIRE(!solid.lines.empty());
    const double far = diagonal(pet);
    for (const SurfaceLine& line : solid.lines) {
      for (const Vec3& point : line.points) {
        CHECK(tree.nearest(point, far).distance < 1e-9 * far);
        CHECK(point.z() > 0);
      }
    }
    CHECK(solid.used == Approx(1).margin(0.06));
  }
}

TEST_CASE("a region is found behind a gap of its outline, and under fur") {
  for (const double gap : {0.05, 0.1, 0.15}) {
    INFO("gap " << gap);
    Drawing drawing;
    std::vector<Vec2> points;
    for (int i = 0; i <= 100; ++i) {
      const double angle = 2 * pi * (1 - gap) * i / 100;
      points.emplace_back(200 * std::cos(angle), 150 * std::sin(angle));
    }
    drawing.strokes.push_back(stroke_of("open", points));
    std::vector<Vec2> fur;
    for (int i = 0; i < 200; ++i) fur.emplace_back(0.4 * i - 40 + 30 * std::cos(0.5 * i), 30 * std::sin(0.5 * i));
    drawing.strokes.push_back(stroke_of("fur", fur));
    const SampledDrawing sampled = sample_strokes(drawing, StrokeOptions{});
    const Envelope envelope = enclosed_regions(sampled.strokes);
    REQUIRE(envelope.regions.size() == 1);
    const double whole = pi * 200 * 150;
    CHECK(envelope.regions.front().area > (1 - gap) * whole);
    CHECK(envelope.regions.front().area < 1.02 * whole);
    CHECK(envelope.seen[0] > 0.9);
    CHECK(envelope.outside[1] == 0);
  }
}

TEST_CASE("what leaves an outline of tufts outwards is a limb, what leaves it inwards is drawn on the body") {
  Random random(4);
  Drawing drawing;
  const auto on_body = [](double degrees) {
    return Vec2(200 * std::cos(degrees * pi / 180), 130 * std::sin(degrees * pi / 180));
  };
  for (int tuft = 0; tuft < 60; ++tuft) {
    const double at = 6.0 * tuft, turn = random.between(-0.6, 0.6);
    const Vec2 middle = on_body(at), along = (on_body(at + 1) - on_body(at - 1)).normalized();
    const Vec2 across(-along.y(), along.x());
    const Vec2 half = 9 * (std::cos(turn) * along + std::sin(turn) * across);
    drawing.strokes.push_back(stroke_of("tuft" + std::to_string(tuft), {middle - half, middle, middle + half}));
  }
  std::vector<Vec2> leg, curl;
  for (double degrees = 240; degrees <= 262; degrees += 2) leg.push_back(on_body(degrees));
  for (double y = -135; y >= -250; y -= 5) leg.emplace_back(leg.back().x(), y);
  for (double degrees = 60; degrees <= 84; degrees += 2) curl.push_back(on_body(degrees));
  for (double y = 125; y >= 0; y -= 5) curl.emplace_back(curl.back().x(), y);
  drawing.strokes.push_back(stroke_of("leg", leg));
  drawing.strokes.push_back(stroke_of("curl", curl));
  const Solid solid = solid_read(drawing);
  CHECK(kinds_by_id(drawing, read(drawing))["leg"] == StrokeKind::Tube);
  CHECK(std::ranges::min(solid.mesh.positions, {}, [](const Vec3& p) { return p.y(); }).y() < -230);
  double shown = 0;
  for (const SurfaceLine& line : solid.lines) {
    if (drawing.strokes[line.stroke].id != "curl") continue;
    for (std::size_t i = 1; i < line.points.size(); ++i) shown += (line.points[i] - line.points[i - 1]).norm();
  }
  CHECK(shown > 80);
}

TEST_CASE("ends that meet are joined at the least cost, and cheaper the nearer they are") {
  double last = -1;
  for (const double gap : {1.0, 5.0, 20.0, 40.0}) {
    Drawing drawing =
        drawing_of({stroke_of("a", {{0, 0}, {100, 0}, {400, 0}}), stroke_of("b", {{400 + gap, 0}, {600, 0}, {900, 0}}),
                    stroke_of("c", {{400, 300}, {600, 500}})});
    const SampledDrawing sampled = sample_strokes(drawing, Options::of(Preset::Tablet).strokes);
    const Connections found = find_connections(sampled.strokes, sampled.scale, Progress{});
    const auto cheapest = std::ranges::min_element(found.joins, {}, &EndJoin::cost);
    REQUIRE(cheapest != found.joins.end());
    CHECK(found.ends[cheapest->a].stroke == 0);
    CHECK(found.ends[cheapest->b].stroke == 1);
    CHECK(cheapest->cost > last);
    last = cheapest->cost;
  }
}

TEST_CASE("lines with hidden ends that cross in full view are not both contours in another reading") {
  Drawing drawing = with_body({200, 90});
  for (const double x : {-40.0, 0.0}) {  // legs that overlap
    std::vector<Vec2> leg{{x, belly(x)}};
    for (int i = 0; i <= 12; ++i) {
      leg.emplace_back(x + 35 - 35 * std::cos(pi * i / 12), -220 - 35 * std::sin(pi * i / 12));
    }
    leg.emplace_back(x + 70, belly(x + 70));
    drawing.strokes.push_back(stroke_of(x < 0 ? "left" : "right", leg));
  }
  const SampledDrawing sampled = sample_strokes(drawing, Options::of(Preset::Tablet).strokes);
  const Connections found = find_connections(sampled.strokes, sampled.scale, Progress{});
  const Envelope envelope = enclosed_regions(sampled.strokes);
  ReadingProgram program(sampled.strokes, found, envelope);
  const auto contours = [](const Reading& reading) { return std::ranges::count(reading.kinds, LineKind::Contour); };
  const auto has_hidden_ends = [&](const Reading& reading, Index stroke) {
    return std::ranges::any_of(reading.meetings,
                               [&](Index meeting) { return found.ends[found.meetings[meeting].end].stroke == stroke; });
  };
  const std::optional<Reading> first = program.best();
  REQUIRE(first);
  REQUIRE(contours(*first) == 3);
  CHECK_FALSE(program.exclude_crossing(*first, 0, 1, {0, -89}));  // a closed line lies in front or behind
  CHECK(contours(*program.best()) == 3);
  REQUIRE(program.exclude_crossing(*first, 1, 2, {15, -254}));
  for (int k = 0; k < 6; ++k) {
    const std::optional<Reading> other = program.best();
    REQUIRE(other);
    CHECK_FALSE((has_hidden_ends(*other, 1) && has_hidden_ends(*other, 2)));
    program.exclude(*other, {}, true);
  }
}

TEST_CASE("what lies between two legs is outside, however near their feet are") {
  for (const double between : {8.0, 15.0, 25.0}) {
    for (const double width : {20.0, 30.0}) {
      INFO(between << " between legs of width " << width);
      Drawing drawing = with_body({200, 90});
      std::vector<Vec2> middles, gaps;
      for (const double x : {-110.0, 60.0}) {
        for (int leg = 0; leg < 2; ++leg) {
          const double left = x + leg * (width + between), right = left + width;
          drawing.strokes.push_back(
              stroke_of("leg" + std::to_string(drawing.strokes.size()),
                        {{left, belly(left)}, {left, -230}, {right, -230}, {right, belly(right)}}));
          middles.emplace_back(left + width / 2, -170);
        }
        gaps.emplace_back(x + width + between / 2, -170);
      }
      const Envelope envelope = enclosed_regions(sample_strokes(drawing, StrokeOptions{}).strokes);
      for (const Vec2& place : middles) CHECK(lies_within(envelope, place));
      for (const Vec2& place : gaps) CHECK_FALSE(lies_within(envelope, place));
      CHECK(lies_within(envelope, Vec2::Zero()));
    }
  }
}

TEST_CASE("two lines that leave the foot open are one leg") {
  for (const double width : {20.0, 28.0, 36.0}) {
    INFO(width);
    Drawing drawing = with_body({200, 90});
    for (const double x : {-60.0, 60.0}) {
      drawing.strokes.push_back(stroke_of("front" + std::to_string(x), {{x, belly(x) - 2}, {x, -205}}));
      drawing.strokes.push_back(
          stroke_of("back" + std::to_string(x), {{x + width, belly(x + width) - 2}, {x + width, -208}}));
    }
    const LabelledDrawing labelled = read(drawing);
    CHECK_FALSE(has_errors(labelled.findings));
    for (const StrokeKind kind : labelled.kinds) CHECK(kind == StrokeKind::Contour);
    CHECK(counts_of(labelled).objects == 3);
  }
}

TEST_CASE("a head beside its body grows out of it where parts are attached") {
  for (const double gap : {-2.0, 0.0, 3.0, 9.0}) {
    INFO("gap " << gap);
    Drawing drawing = with_body({200, 120});
    drawing.strokes.push_back(oval("head", {-200 - gap - 60, 0}, {60, 60}, 357));
    drawing.strokes.push_back(stroke_of("eye", {{-280, 15}, {-272, 25}, {-265, 17}}));
    CHECK(solid_read(drawing).shells.size() == 2);
    Options options = Options::of(Preset::Tablet);
    options.attach_suggested = true;
    CHECK(label_quietly(drawing, options).crossings.empty());
    const Solid together = test::solid_of(drawing, options);
    CHECK_FALSE(has_errors(together.findings));
    REQUIRE(together.shells.size() == 1);
    CHECK(together.shells.front().euler_mesh == 2);
  }
}

TEST_CASE("what is made of several lines beside something larger is a thing of its own") {
  Drawing drawing = with_body({200, 120});
  drawing.strokes.push_back(oval("apple", {-265, 0}, {60, 60}));
  drawing.strokes.push_back(stroke_of("stalk", {{-275, 60}, {-280, 110}, {-265, 110}, {-262, 60}}));
  Options options = Options::of(Preset::Tablet);
  options.attach_suggested = true;
  CHECK(test::solid_of(drawing, options).shells.size() == 2);
}

TEST_CASE("a dot on a surface is a detail, and one beside it is left out by name") {
  Drawing drawing = with_body({200, 120});
  drawing.strokes.push_back(stroke_of("eye", {{-100, 30}, {-99, 31}, {-98, 30}}));
  drawing.strokes.push_back(stroke_of("speck", {{260, 30}, {261, 31}, {262, 30}}));
  const LabelledDrawing labelled = read(drawing);
  CHECK(kinds_by_id(drawing, labelled)["eye"] == StrokeKind::Detail);
  REQUIRE(labelled.findings.size() == 1);
  CHECK(labelled.findings.front().code == "W_TINY");
  CHECK(strokes_named(labelled.findings.front()) == std::vector<std::string>{"speck"});
  const Solid solid = solid_read(drawing);
  REQUIRE(solid.lines.size() == 1);
  CHECK(drawing.strokes[solid.lines.front().stroke].id == "eye");
}

TEST_CASE("a dot is named though nothing else of its drawing can be read") {
  Drawing drawing = drawing_of({of_kind(stroke_of("line", {{0, 0}, {100, 0}, {400, 0}}), StrokeKind::Detail),
                                stroke_of("speck", {{200, 50}, {201, 51}, {202, 50}})});
  const Findings findings = findings_of(drawing);
  REQUIRE(findings.size() == 2);
  CHECK(findings[0].code == "W_TINY");
  CHECK(findings[1].severity == Severity::Error);
}

TEST_CASE("a few spots on a body are parts of it, many are its pattern") {
  for (const auto& [count, kind] : {std::pair(3, StrokeKind::Blob), std::pair(12, StrokeKind::Detail)}) {
    Drawing drawing = with_body({200, 120});
    for (int spot = 0; spot < count; ++spot) {
      const double at = 2 * pi * spot / count;
      drawing.strokes.push_back(oval("spot" + std::to_string(spot), {120 * std::cos(at), 70 * std::sin(at)}, {14, 12}));
    }
    const LabelledDrawing labelled = read(drawing);
    INFO(count << " spots");
    CHECK_FALSE(has_errors(labelled.findings));
    CHECK(std::ranges::count(labelled.kinds, kind) == count);
  }
}

TEST_CASE("an animal of sticks alone is a solid, and a letter beside it is none") {
  for (const double gap : {0.0, 4.0}) {
    Drawing drawing;
    const auto add = [&](const char* id, const std::vector<Vec2>& points) {
      drawing.strokes.push_back(stroke_of(id, points));
    };
    add("tube-back", {{0, 0}, {100, 3}, {200, 0}});
    add("tube-fore", {{6, -gap}, {2, -50}, {5, -95}});
    add("tube-hind", {{192, -gap}, {195, -50}, {190, -95}});
    add("tube-neck", {{200 + gap, 0}, {215, 30}, {235, 60}});
    add("ignored-letter", {{20, 120}, {20, 100}, {30, 100}});
    const LabelledDrawing labelled = read(drawing);
    INFO("gap " << gap);
    CHECK_FALSE(has_errors(labelled.findings));
    CHECK(labelled.figures.size() == 1);
    for (const auto& [id, kind] : kinds_by_id(drawing, labelled)) CHECK(id.starts_with(to_string(kind)));
  }
}

TEST_CASE("two lines within an outline that leave a wide gap are drawn on it") {
  for (const double apart : {40.0, 70.0}) {
    Drawing drawing = with_body({200, 120});
    for (const double side : {1.0, -1.0}) {
      std::vector<Vec2> points;
      for (int i = 0; i <= 40; ++i) {
        const double x = i / 40.0;  // nearer to one another on the right
        points.emplace_back(-120 + 240 * x, side * apart * (0.5 - 0.25 * x) + 6 * std::abs(std::sin(9 * x)));
      }
      drawing.strokes.push_back(stroke_of(side > 0 ? "upper" : "lower", points));
    }
    const LabelledDrawing labelled = read(drawing);
    INFO("apart by " << apart);
    CHECK_FALSE(has_errors(labelled.findings));
    CHECK(std::ranges::count(labelled.kinds, StrokeKind::Detail) == 2);
  }
}
