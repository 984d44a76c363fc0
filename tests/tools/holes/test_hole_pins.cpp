// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/tools/holes/hole_pins.h"
#include "support/random.h"
#include "tools/holes/hole_rings.h"
#include "tools/pointer/mesh_views.h"

namespace croquis {
namespace {

using test::TestCamera;

/// Every hole once, no two pins over each other, none far from its place.
void check_layout(const std::vector<HolePin>& pins, std::size_t holes, const HolePinOptions& options) {
  std::multiset<Index> pinned;
  for (const HolePin& pin : pins) {
    pinned.insert(pin.holes.begin(), pin.holes.end());
    CHECK(std::binary_search(pin.holes.begin(), pin.holes.end(), pin.hole));
    CHECK((pin.pixel - pin.anchor).norm() <= options.most_moved + 1e-9);
  }
  CHECK(pinned.size() == holes);
  CHECK(std::set<Index>(pinned.begin(), pinned.end()).size() == holes);
  double nearest = 1e300;
  for (std::size_t i = 0; i < pins.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (pins[i].pixel - pins[j].pixel).norm());
  }
  CHECK(nearest >= 2 * options.radius + options.gap - 1e-9);
}

TEST_CASE("rims read from lines have their middle, their outside and their size") {
  // A square seen from +z: the surface around it runs counter-clockwise, so its rim runs clockwise.
  PolyMesh lines;
  lines.positions = {{0, 0, 5}, {0, 4, 5}, {4, 4, 5}, {4, 0, 5}, {9, 9, 9}};
  lines.line_vertices = {0, 1, 2, 3, 0};
  lines.line_offsets = {0, 5};
  const std::vector<HoleRim> rims = rims_from_lines(lines);
  REQUIRE(rims.size() == 1);
  CHECK(rims[0].id == 0);
  CHECK(rims[0].points.size() == 4);
  CHECK((rims[0].at - Vec3(2, 2, 5)).norm() < 1e-12);
  CHECK((rims[0].normal - Vec3(0, 0, 1)).norm() < 1e-12);
  CHECK(rims[0].radius == Approx(std::sqrt(8.0)));
}

TEST_CASE("a rim's middle doesn't depend on how densely its parts are sampled") {
  PolyMesh lines;
  for (int i = 0; i < 50; ++i) lines.positions.push_back({i / 50.0, 0, 0});
  lines.positions.insert(lines.positions.end(), {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  for (Index v = 0; v < lines.positions.size(); ++v) lines.line_vertices.push_back(v);
  lines.line_offsets = {0, static_cast<Index>(lines.line_vertices.size())};
  CHECK((rims_from_lines(lines)[0].at - Vec3(0.5, 0.5, 0)).norm() < 1e-12);
}

TEST_CASE("a hole without room is no crash") {
  PolyMesh lines;
  lines.positions = {{1, 2, 3}};
  lines.line_vertices = {0, 0};
  lines.line_offsets = {0, 0, 1, 2};
  const std::vector<HoleRim> rims = rims_from_lines(lines);
  REQUIRE(rims.size() == 3);
  CHECK(rims[0].points.empty());
  CHECK(rims[2].at == Vec3(1, 2, 3));
  CHECK(rims[2].normal == Vec3::Zero());
  CHECK(place_pins(rims, TestCamera{}.frame()).size() <= 3);
}

TEST_CASE("a pin with room stands at its hole") {
  TestCamera camera;
  camera.perspective = GENERATE(true, false);
  if (!camera.perspective) camera.half_height = 2;
  const std::vector<HoleRim> rims = {test::ring(0, {-1, 0, 0}, 0.2), test::ring(1, {1, 0.5, 0}, 0.2)};
  const std::vector<HolePin> pins = place_pins(rims, camera.frame());
  REQUIRE(pins.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(pins[i].hole == i);
    CHECK_FALSE(pins[i].moved());
    CHECK((pins[i].pixel - camera.pixel_of(rims[i].at)).norm() < 1e-6);
    CHECK((pins[i].place - rims[i].at).norm() < 1e-9);
  }
}

TEST_CASE("pins show which holes face away and holes that are hidden") {
  TestCamera camera;
  std::vector<HoleRim> rims = {test::ring(0, {-1, 0, 0}, 0.2), test::ring(1, {0, 0, 0}, 0.2),
                               test::ring(2, {1, 0, 0}, 0.2)};
  rims[1].normal = {0, 0, -1};
  const auto sight = [](const ViewFrame&, const Vec3& place) { return place.x() < 0.5; };
  const std::vector<HolePin> pins = place_pins(rims, camera.frame(), {}, sight);
  REQUIRE(pins.size() == 3);
  CHECK((pins[0].facing && pins[0].visible));
  CHECK((!pins[1].facing && pins[1].visible));
  CHECK((pins[2].facing && !pins[2].visible));
}

TEST_CASE("holes behind the eye or outside the view have no pin") {
  const std::vector<HoleRim> rims = {test::ring(0, {0, 0, 9}, 0.2), test::ring(1, {40, 0, 0}, 0.2)};
  CHECK(place_pins(rims, TestCamera{}.frame()).empty());
}

TEST_CASE("pins that would cover each other are pushed apart, the larger hole's stays") {
  const std::vector<HoleRim> rims = {test::ring(0, {0, 0, 0}, 0.1), test::ring(1, {0.02, 0, 0}, 0.3),
                                     test::ring(2, {-0.02, 0.01, 0}, 0.2)};
  const std::vector<HolePin> pins = place_pins(rims, TestCamera{}.frame());
  REQUIRE(pins.size() == 3);
  CHECK_FALSE(pins[1].moved());
  CHECK(pins[0].moved());
  CHECK(pins[2].moved());
  check_layout(pins, 3, {});
  // A moved pin's place of the model is the one seen at its pixel.
  for (const HolePin& pin : pins) CHECK((TestCamera{}.pixel_of(pin.place) - pin.pixel).norm() < 1e-6);
}

TEST_CASE("any crowd of holes gets pins that are apart, the same ones however the holes come") {
  const unsigned seed = GENERATE(1U, 2U, 3U);
  test::Random random(seed);
  std::vector<HoleRim> rims;
  for (Index i = 0; i < 400; ++i) {
    const double width = i % 2 == 0 ? 0.15 : 1.5;  // half of them in one small place
    rims.push_back(
        test::ring(i, {random.between(-width, width), random.between(-width, width), 0}, random.between(0.01, 0.1)));
  }
  const std::vector<HolePin> pins = place_pins(rims, TestCamera{}.frame());
  check_layout(pins, rims.size(), {});
  CHECK(std::any_of(pins.begin(), pins.end(), [](const HolePin& pin) { return pin.holes.size() > 1; }));

  std::reverse(rims.begin(), rims.end());
  const std::vector<HolePin> again = place_pins(rims, TestCamera{}.frame());
  REQUIRE(again.size() == pins.size());
  for (std::size_t i = 0; i < pins.size(); ++i) {
    CHECK(again[i].holes == pins[i].holes);
    CHECK(again[i].pixel == pins[i].pixel);
  }
}

}  // namespace
}  // namespace croquis
