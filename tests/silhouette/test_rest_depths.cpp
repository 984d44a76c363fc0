// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/skeleton/rest_depths.h"
#include "croquis/base/error.h"
#include "silhouette/solids.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::PartDepth;

namespace {

/// @param held as suggested; parts aren't united then, so that each can be measured
Solid solid_of(const Drawing& drawing, bool held = false) {
  Options options;
  options.attach_suggested = held;
  if (held) options.quality = Quality::Draft;
  return test::solid_of(drawing, options);
}

std::map<std::string, PartDepth> reaches(const Drawing& drawing, bool held = false) {
  return test::depths_by_name(solid_of(drawing, held));
}

std::map<std::string, PartDepth> reaches(const std::string& character, bool held = false) {
  return reaches(test::character_named(character).drawing, held);
}

/// Objects with one node each.
Skeleton nodes_of(const std::vector<double>& radii) {
  Skeleton skeleton;
  skeleton.scale = 1;
  for (Index object = 0; object < radii.size(); ++object) {
    SkeletonNode node;
    node.object = object;
    node.radius = radii[object];
    skeleton.nodes.push_back(node);
  }
  return skeleton;
}

std::vector<double> rest(const std::vector<double>& radii, const ObjectBounds& bounds,
                         const DepthSettings& settings = {}) {
  Progress progress;
  return rest_depths(nodes_of(radii), bounds, settings, progress);
}

}  // namespace

TEST_CASE("objects that lie over one another all round are one cycle, numbered from below") {
  const OverlapCycles cycles = overlap_cycles({{1}, {2}, {0, 3}, {}, {0, 0, 4}});
  CHECK(cycles.count == 3);
  CHECK(cycles.cycle == std::vector<Index>{1, 1, 1, 0, 2});
  CHECK(overlap_cycles({}).count == 0);
}

TEST_CASE("flat objects lie as near to each other as their bounds allow, the larger one nearer to the plane") {
  const std::vector<double> pair = rest({10, 1}, {{{1, 0}, 11}});
  CHECK(pair[1] - pair[0] == Approx(11).margin(1e-3));
  CHECK(std::abs(pair[0]) < 0.02 * pair[1]);
  CHECK(rest({10, 1}, {}) == std::vector<double>{0, 0});
  const std::vector<double> chain = rest({1, 1, 1}, {{{2, 1}, 2}, {{1, 0}, 3}});
  CHECK(chain[2] - chain[1] == Approx(2).margin(1e-3));
  CHECK(chain[1] - chain[0] == Approx(3).margin(1e-3));
  // Each over the next: none of them can be flat.
  CHECK(rest({1, 2, 3}, {{{0, 1}, 3}, {{1, 2}, 5}, {{2, 0}, 4}}) == std::vector<double>{0, 0, 0});
}

TEST_CASE("like parts of a body lie equally far before and behind it, unlike ones as near as they can") {
  // Four legs and a thin tail.
  const std::vector<double> heights =
      rest({10, 3, 3.1, 2.9, 3, 0.5}, {{{1, 0}, 9}, {{2, 0}, 11}, {{0, 3}, 8}, {{0, 4}, 10}, {{0, 5}, 4}});
  for (const std::size_t leg : {1U, 2U, 3U, 4U}) CHECK(std::abs(heights[leg] - heights[0]) == Approx(11).epsilon(0.01));
  CHECK(heights[0] - heights[5] == Approx(4).margin(1e-2));
}

TEST_CASE("an object's weight of distance holds it near the plane") {
  DepthSettings settings;
  settings.object_weights = {{1, 0.1, 0.1}, {1, 0.1, 1}};
  const std::vector<double> heights = rest({3, 3}, {{{1, 0}, 6}}, settings);
  CHECK(std::abs(heights[1]) < 0.1 * std::abs(heights[0]));
}

TEST_CASE("a small thing before, behind or beside a body leaves it as deep as it is wide") {
  const int count = test::sample_count(12, 200);
  for (int seed = 0; seed < count; ++seed) {
    INFO(seed);
    test::Random random(static_cast<std::uint64_t>(seed));
    const double width = seed % 3 == 0 ? random.between(1.2, 3) : 1;
    const double radius = 200 / random.between(3, 40);
    const double angle = random.between(0, 6.28);
    const Vec2 rim(200 * width * std::cos(angle), 200 * std::sin(angle));
    const std::vector<Vec2> worm = test::limb_outline({0.6 * rim, 1.3 * rim}, {radius, radius});
    const std::vector<Vec2> body = test::ellipse({0, 0}, 200 * width, 200);
    const std::map<std::string, PartDepth> parts =
        reaches(test::layered_sketch({{body, 1}, {worm, seed % 2 == 0 ? 2 : 0}}).drawing);
    REQUIRE(parts.size() == 2);
    double deepest = 0;
    for (const auto& [name, reach] : parts) deepest = std::max(deepest, reach.depth());
    CHECK(deepest / 400 > 0.9);
    CHECK(deepest / 400 < 1.1);
  }
}

TEST_CASE("a ball with a ring round it, a needle behind it or an eye on it stays a ball") {
  const auto level = [](double height) { return [height](double) { return height; }; };
  const test::TubeStrand ball = test::bar({-1, 0}, {1, 0}, 200, level(0));
  const auto check = [](const Solid& solid) {
    double deepest = 0;
    for (const auto& [name, reach] : test::depths_by_name(solid)) deepest = std::max(deepest, reach.depth());
    CHECK(deepest / 401 > 0.9);
    CHECK(deepest / 401 < 1.1);
  };
  const int count = test::sample_count(4, 60);
  for (int seed = 0; seed < count; ++seed) {
    INFO(seed);
    test::Random random(static_cast<std::uint64_t>(seed));
    const double radius = random.between(4, 20);
    const double y = random.between(-120, 120);
    const double slant = random.between(-60, 60);
    check(
        solid_of(test::tube_sketch({ball, test::bar({-320, y - slant}, {320, y + slant}, radius, level(-1))}).drawing));

    // As Saturn has one: its lower half before the ball.
    const Vec2 axes(random.between(260, 330), random.between(80, 140));
    const auto turn = [](double t) { return 2 * std::numbers::pi * t; };
    const test::TubeStrand ring{
        [=](double t) { return Vec2(axes.x() * std::cos(turn(t)), axes.y() * std::sin(turn(t))); },
        [=](double) { return std::min(radius, 15.0); }, [=](double t) { return -std::sin(turn(t)); }};
    const Solid saturn = solid_of(test::tube_sketch({ball, ring}).drawing);
    // The ring is bent round the ball, and deeper.
    const std::map<std::string, PartDepth> parts = test::depths_by_name(saturn);
    REQUIRE(parts.size() == 2);
    const bool found = std::any_of(parts.begin(), parts.end(), [](const auto& part) {
      return part.second.depth() > 0.9 * 401 && part.second.depth() < 1.1 * 401;
    });
    CHECK(found);

    const Vec2 eye(random.between(-100, 100), random.between(-100, 100));
    check(solid_of(
        test::layered_sketch({{test::ellipse({0, 0}, 200.5, 200.5), 1}, {test::circle_outline(eye, 2 * radius), 2}})
            .drawing,
        true));
  }
}

TEST_CASE("parts that can be flat are flat, and legs don't splay") {
  const auto elephant = reaches("elephant");
  for (const char* leg : {"near fore leg", "near hind leg", "far fore leg", "far hind leg"}) {
    INFO(leg);
    const double thickness = elephant.at(leg).depth();
    CHECK(thickness < 135);  // its width is at most 120
  }
  const double body = elephant.at("body").middle();
  const double before = elephant.at("near fore leg").middle() - body;
  CHECK(elephant.at("near hind leg").middle() - body == Approx(before).epsilon(0.05));
  CHECK(body - elephant.at("far fore leg").middle() == Approx(before).epsilon(0.2));
  CHECK(body - elephant.at("far hind leg").middle() == Approx(before).epsilon(0.2));
  CHECK(elephant.at("body").depth() == Approx(306).epsilon(0.05));
}

TEST_CASE("legs that grow out of a body mirror each other, too, as far as they reach it") {
  const auto elephant = reaches("elephant", true);
  const double body = elephant.at("body").middle();
  const double before = elephant.at("near fore leg").middle() - body;
  CHECK(before > 40);
  CHECK(elephant.at("near hind leg").middle() - body == Approx(before).epsilon(0.05));
  CHECK(body - elephant.at("far fore leg").middle() == Approx(before).epsilon(0.15));
  CHECK(body - elephant.at("far hind leg").middle() == Approx(before).epsilon(0.15));
}

TEST_CASE("limbs that like ones draw out of their body go no farther than they reach") {
  DepthSettings settings;
  for (const Index limb : {1U, 2U, 3U}) settings.attachments.held[{0, limb}] = {Hold::Joined, 0.5};
  const ObjectBounds bounds{{{1, 0}, {9, 12}}, {{0, 2}, {3, 8}}, {{0, 3}, {4, 20}}};
  const std::vector<double> heights = rest({10, 3, 3, 3}, bounds, settings);
  CHECK(heights[1] - heights[0] == Approx(9).epsilon(0.01));
  CHECK(heights[0] - heights[2] == Approx(8).epsilon(0.01));
  CHECK(heights[0] - heights[3] == Approx(9).epsilon(0.01));
}

TEST_CASE("depths turn, are mirrored and grow with the drawing") {
  for (const char* name : {"elephant", "pancakes", "flower"}) {
    const test::Sketch sketch = test::character_named(name);
    const Solid solid = solid_of(sketch.drawing);
    const double depth = test::depth_of(solid.mesh);
    const std::map<std::string, PartDepth> drawn = test::depths_by_name(solid);
    const auto check = [&](const test::Sketch& other, double factor) {
      const std::map<std::string, PartDepth> parts = reaches(other.drawing);
      REQUIRE(parts.size() == drawn.size());
      for (const auto& [part, reach] : drawn) {
        INFO(name << " " << part);
        const double tolerance = 0.01 * factor * depth;
        CHECK(parts.at(part).middle() == Approx(factor * reach.middle()).margin(tolerance));
        CHECK(parts.at(part).depth() == Approx(factor * reach.depth()).margin(tolerance));
      }
    };
    check(test::mirrored(sketch), 1);
    check(test::scaled(sketch, 0.2), 0.2);
    check(test::rotated(sketch, 2), 1);
  }
}

TEST_CASE("parts of characters lie no further apart than their thicknesses") {
  for (const char* name : {"elephant", "pancakes", "snowman", "flower"}) {
    INFO(name);
    const Solid solid = solid_of(test::character_named(name).drawing);
    double thicknesses = 0;
    for (const test::PartDepth& part : test::part_depths(solid)) thicknesses += part.depth();
    CHECK(test::depth_of(solid.mesh) <= 1.05 * thicknesses);
  }
}

TEST_CASE("characters are flat parts near to one another, as deep as their drawings explain") {
  for (const test::Character& character : test::all_characters()) {
    for (const bool held : {false, true}) {
      INFO(character.name << " " << held);
      Options options;
      options.quality = Quality::Draft;
      options.attach_suggested = held;
      const Solid solid = test::solid_of(test::character_sketch(character).drawing, options);
      const std::vector<test::PartDepth> parts = test::part_depths(solid);
      // The worst are a stack of pancakes, and the arms of an octopus that lean because their body pulls them.
      CHECK(test::middle_spread(parts) < (held ? 0.65 : 0.85));
      CHECK(test::steepest(parts) < (held ? 1.0 : 0.03));
      CHECK(solid.diagnostics.depth_ratio < 1.1);
    }
  }
}

TEST_CASE("parts are as thick as their strokes say, and nothing else of them changes") {
  const auto level = [](double) { return 0.0; };
  const Drawing plain = test::layered_sketch({{test::circle_outline({0, 0}, 150), 1},
                                              {test::tube_outline(test::bar({60, -60}, {260, -260}, 40, level)), 2}})
                            .drawing;
  for (const std::array<double, 2>& factors : {std::array{0.1, 0.1}, {0.5, 1.0}, {2.0, 2.0}, {4.0, 0.05}}) {
    INFO(factors[0] << " " << factors[1]);
    Drawing drawing = plain;
    const std::map<std::string, PartDepth> before = reaches(plain);
    REQUIRE(before.size() == 2);
    std::map<std::string, double> factor_of;
    for (const auto& [name, reach] : before) factor_of[name] = factors[factor_of.size()];
    for (Stroke& stroke : drawing.strokes) {
      const auto given = factor_of.find(stroke.id);
      if (given != factor_of.end()) stroke.data["thickness"] = std::to_string(given->second);
    }
    const Solid solid = solid_of(drawing);
    CHECK(solid.findings.empty());
    CHECK(solid.diagnostics.silhouette_iou >= 0.98);
    CHECK(solid.diagnostics.depth_ratio <= 1.2);
    CHECK(solid.diagnostics.minimum_gap >= 0.1 * solid.diagnostics.scale - 1e-6);
    test::check_sound(solid.mesh);
    for (const auto& [name, reach] : test::depths_by_name(solid)) {
      CHECK(reach.depth() == Approx(factor_of[name] * before.at(name).depth()).epsilon(0.02));
    }
  }
}

TEST_CASE("a thickness that is no number from 0.05 to 4 is refused by name") {
  for (const char* text : {"0.04", "4.1", "-1", "thin", ""}) {
    INFO(text);
    Drawing drawing = test::circle_sketch().drawing;
    drawing.strokes[0].data["thickness"] = text;
    try {
      solid_of(drawing);
      FAIL("it became a solid");
    } catch (const Error& error) {
      REQUIRE(error.findings().size() == 1);
      CHECK(error.findings()[0].code == "E_PARAMETER");
      CHECK(error.findings()[0].message.find(drawing.strokes[0].id) != std::string::npos);
    }
  }
}
