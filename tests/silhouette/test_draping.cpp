// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "silhouette/solids.h"
#include "silhouette/surface_quality.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::depth_of;

namespace {

using Outline = std::vector<Vec2>;

/// Each outline lies on all those before it.
struct Stack {
  Solid solid;
  std::vector<PolyMesh> parts;  ///< by outline

  explicit Stack(const std::vector<Outline>& outlines) {
    test::Character character{"stack", {}};
    Options options;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      character.parts.push_back({"part " + std::to_string(k), outlines[k], {}});
      if (k > 0) options.attach.push_back({"part " + std::to_string(k), "part " + std::to_string(k - 1)});
    }
    for (AttachedPair& pair : options.attach) pair.hold = Hold::Resting;
    Drawing drawing = test::character_sketch(character).drawing;
    for (Stroke& stroke : drawing.strokes) stroke.data["kind"] = "part";
    solid = test::solid_of(drawing, options);
    for (const test::CharacterPart& part : character.parts) parts.push_back(test::part_named(solid, part.name));
  }

  /// From the front of one to the back of the next over a place; a huge number where one of them isn't there.
  double distance(std::size_t lower, const Vec2& place) const {
    const std::vector<double> below = test::vertical_hits(parts[lower], place);
    const std::vector<double> above = test::vertical_hits(parts[lower + 1], place);
    return below.empty() || above.empty() ? 1e300 : above.front() - below.back();
  }

  void check_sound() const {
    CHECK(solid.findings.empty());
    CHECK(solid.diagnostics.silhouette_iou >= 0.98);
    test::check_sound(solid.mesh);
  }
};

Vec2 on_circle(double radius, double angle) { return radius * Vec2(std::cos(angle), std::sin(angle)); }

/// Places within a circle.
std::vector<Vec2> places_in(const Vec2& centre, double radius) {
  std::vector<Vec2> places;
  for (const double part : {0.15, 0.5, 0.85}) {
    for (int k = 0; k < 8; ++k) places.push_back(centre + on_circle(part * radius, k * 0.785 + part));
  }
  return places;
}

double lowest_of(const PolyMesh& mesh) { return test::report_of(mesh).bounds->front().z(); }

}  // namespace

TEST_CASE("a button anywhere on a ball lies on it all over, and the ball stays round") {
  // All but a few in a hundred keep the narrow bounds: wide buttons at the ball's edge bend it a little.
  const int count = test::sample_count(10, 200), most = count * 6 / 100;
  int bent = 0, apart = 0;
  double slender = 0;
  for (int seed = 0; seed < count; ++seed) {
    INFO(seed);
    test::Random random(static_cast<std::uint64_t>(seed));
    const double radius = random.between(15, 90);
    const Vec2 centre = on_circle(random.between(0, 185 - radius), random.between(0, 6.28));
    const Stack stack({test::ellipse({0, 0}, 200, 200), test::ellipse(centre, radius, radius)});
    stack.check_sound();
    CHECK(depth_of(stack.parts[1]) >= 1.6 * radius);
    // The ball stays round behind the button and beside it: half of the button lies in a hollow.
    double bend = 0;
    for (const Vec2& place : places_in({0, 0}, 150)) {
      const std::vector<double> hits = test::vertical_hits(stack.parts[0], place);
      REQUIRE(hits.size() == 2);
      const double half = std::sqrt(200 * 200 - place.squaredNorm());
      const double middle = lowest_of(stack.parts[0]) + 200;
      bend = std::max(bend, std::abs((middle - hits[0]) / half - 1));
      if ((place - centre).norm() > 1.05 * radius) bend = std::max(bend, std::abs((hits[1] - middle) / half - 1));
    }
    CHECK(bend < 0.04);
    bent += bend > 0.02 ? 1 : 0;
    slender += 100 * test::slender_share(stack.parts[1]) / count;
    double gap = 0;  // in parts of what it may be
    for (const Vec2& place : places_in(centre, radius)) {
      const double distance = stack.distance(0, place);
      CHECK(distance > 0);
      gap = std::max(gap, distance / (0.05 * radius + 0.02 * stack.solid.diagnostics.scale));
    }
    CHECK(gap < 1.6);
    apart += gap > 1 ? 1 : 0;
  }
  CHECK(bent <= most);
  CHECK(apart <= most);
  CHECK(slender < 10);  // though its back has little room in the hollow
}

TEST_CASE("buttons on bellies on bodies lie on one another") {
  const Stack stack({test::ellipse({0, 0}, 200, 300), test::ellipse({30, -60}, 110, 150),
                     test::ellipse({60, -20}, 40, 30), test::ellipse({65, -20}, 12, 12)});
  stack.check_sound();
  for (const auto& [lower, centre, radius] :
       {std::tuple(0U, Vec2(30, -60), 110.0), {1U, Vec2(60, -20), 30.0}, {2U, Vec2(65, -20), 12.0}}) {
    for (const Vec2& place : places_in(centre, radius)) {
      if (stack.distance(lower, place) > 1e299) continue;
      CHECK(stack.distance(lower, place) > 0);
      CHECK(stack.distance(lower, place) < 0.1 * radius + 0.02 * stack.solid.diagnostics.scale);
    }
  }
}

TEST_CASE("a wing that reaches beyond its body goes on without a sharp bend and levels out") {
  for (const double reach : {0.2, 0.6, 1.2, 2.5}) {
    INFO(reach);
    const Outline wing = test::limb_outline({{120, 0}, {200 * (1 + reach), -40}}, {45, 45});
    const Stack stack({test::ellipse({0, 0}, 200, 200), wing});
    stack.check_sound();
    const auto middle = [&](double x) {
      const double y = -40 * (x - 120) / (200 * (1 + reach) - 120);
      const std::vector<double> hits = test::vertical_hits(stack.parts[1], {x, y});
      REQUIRE(hits.size() == 2);
      return (hits[0] + hits[1]) / 2;
    };
    // Up to where its round end begins.
    double last = middle(120);
    double before = 0;
    for (double x = 130; x <= 200 * (1 + reach); x += 10) {
      const double slope = (middle(x) - last) / 10;
      CHECK(std::abs(slope) < 2);
      if (x > 130) CHECK(std::abs(slope - before) < 0.45);
      before = slope;
      last = middle(x);
    }
    const double rim = test::vertical_hits(stack.parts[0], {0, 0}).front() + depth_of(stack.parts[0]) / 2;
    CHECK(lowest_of(stack.parts[1]) > rim - 1);
  }
}

TEST_CASE("balls in a row that cross stay balls, however much of them rests on the next one") {
  const auto deep = [](const std::vector<double>& radii, double overlap, double turn, double scale) {
    test::Character row{"row", {}};
    Vec2 centre(0, 0);
    std::vector<Vec2> centres;
    for (std::size_t k = 0; k < radii.size(); ++k) {
      if (k > 0)
        centre += (radii[k - 1] + radii[k] - overlap * std::min(radii[k - 1], radii[k])) *
                  Vec2(std::sin(turn), std::cos(turn));
      centres.push_back(scale * centre);
      row.parts.push_back(
          {"ball " + std::to_string(k), test::ellipse(centres[k], scale * radii[k], scale * radii[k]), {}});
    }
    Options options;
    options.strokes.crossings = Crossings::Front;
    options.attach_suggested = true;
    const Solid solid = test::solid_of(test::whole_outlines(row), options);
    CHECK(solid.attached.size() == radii.size() - 1);
    for (const SolidAttachment& held : solid.attached) CHECK(held.hold == Hold::Resting);
    test::check_sound(solid.mesh);
    CHECK(test::report_of(solid.mesh).components == radii.size());
    CHECK(solid.diagnostics.silhouette_iou >= 0.98);
    CHECK(solid.diagnostics.minimum_gap > 0);
    for (std::size_t k = 0; k < radii.size(); ++k) {
      const PolyMesh ball = test::part_named(solid, row.parts[k].name);
      INFO("ball " << k);
      CHECK(depth_of(ball) >= 0.95 * 2 * scale * radii[k]);
      CHECK(depth_of(ball) <= 1.2 * 2 * scale * radii[k]);
      const std::vector<double> hits = test::vertical_hits(ball, centres[k]);
      REQUIRE(hits.size() == 2);
      CHECK(hits[1] - hits[0] >= 0.95 * 2 * scale * radii[k]);
    }
  };
  const std::vector<std::vector<double>> rows = {{150, 105}, {150, 120, 90}, {90, 110, 140, 170}};
  for (const std::vector<double>& radii : rows) {
    for (const double overlap : {0.05, 0.3, 0.6, 0.95}) {
      INFO(radii.size() << " balls, overlap " << overlap);
      deep(radii, overlap, 0, 1);
    }
  }
  for (const double turn : {0.4, 5.0}) deep(rows[1], 0.4, turn, 1);
  for (const double scale : {0.01, 30.0}) deep(rows[0], 0.4, 0.2, scale);
}

TEST_CASE("what rests turns, is mirrored and grows with its drawing") {
  const test::Character plain{
      "penguin", {{"body", test::ellipse({0, 0}, 150, 220), {}}, {"belly", test::ellipse({20, -50}, 80, 120), {}}}};
  const auto depth = [](const test::Sketch& sketch) {
    Options options;
    options.attach_suggested = true;
    return depth_of(test::solid_of(sketch.drawing, options).mesh);
  };
  const test::Sketch sketch = test::character_sketch(plain);
  const double drawn = depth(sketch);
  CHECK(depth(test::mirrored(sketch)) == Approx(drawn).epsilon(0.005));
  CHECK(depth(test::scaled(sketch, 5)) == Approx(5 * drawn).epsilon(1e-4));
  CHECK(depth(test::rotated(sketch, 0.7)) == Approx(drawn).epsilon(0.01));
}

TEST_CASE("characters' eyes, windows and bellies lie on what they rest on") {
  // The snowman's nose is thin, with points of other parts right beside its rim.
  for (const char* name : {"penguin", "owl", "car", "snowman"}) {
    INFO(name);
    Options options;
    options.attach_suggested = true;
    const Solid solid = test::solid_of(test::character_named(name).drawing, options);
    test::check_sound(solid.mesh);
    CHECK(!has_errors(solid.findings));
    int resting = 0;
    for (const SolidAttachment& held : solid.attached) {
      if (held.hold != Hold::Resting) continue;
      ++resting;
      INFO(held.a << " " << held.b);
      PolyMesh upper = test::part_named(solid, held.a), lower = test::part_named(solid, held.b);
      const auto bounds = [](const PolyMesh& mesh) { return *test::report_of(mesh).bounds; };
      const auto width = [&](const PolyMesh& mesh) { return bounds(mesh)[1].x() - bounds(mesh)[0].x(); };
      if (width(upper) > width(lower)) std::swap(upper, lower);
      const auto [low, high] = bounds(upper);
      const double radius = std::min(high.x() - low.x(), high.y() - low.y()) / 2;
      for (const Vec2& place : places_in((low + high).head<2>() / 2, radius)) {
        const std::vector<double> below = test::vertical_hits(lower, place);
        const std::vector<double> above = test::vertical_hits(upper, place);
        if (below.empty() || above.empty()) continue;
        CHECK(above.front() > below.back());
        CHECK(above.front() - below.back() < 0.1 * radius + 0.02 * solid.diagnostics.scale);
      }
    }
    CHECK(resting >= 2);
  }
}
