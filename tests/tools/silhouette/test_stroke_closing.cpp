// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/tools/silhouette/stroke_closing.h"
#include "tools/strokes/drawn_strokes.h"

namespace croquis {
namespace {

using test::sampled;

TEST_CASE("ends meet when they are near each other on a stroke long enough to be a loop") {
  const auto arc = [](double turns, double radius) {
    return sampled({"arc",
                    [=](double t) {
                      return Vec2(radius * std::cos(6.283185307 * turns * t),
                                  radius * std::sin(6.283185307 * turns * t));
                    },
                    200})
        .samples;
  };
  CHECK(ends_meet(arc(0.99, 100)));
  CHECK(ends_meet(arc(1.0, 100)));
  CHECK(!ends_meet(arc(0.9, 100)));
  CHECK(!ends_meet(arc(1.0, 5)));
  CloseOptions zoomed;
  zoomed.units_per_pixel = 0.1;
  CHECK(ends_meet(arc(1.0, 5), zoomed));
  CHECK(!ends_meet(arc(0.99, 100), zoomed));
  CHECK(!ends_meet(test::stroke_through({{0, 0}, {1, 0}}, "s").samples));
  CHECK(!ends_meet({}));
}

TEST_CASE("loops of any size close where a hand misses their beginning by two percent of their size") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    const double size = random.between(60, 900);
    const double flat = random.between(0.5, 1);
    const double miss = random.between(-0.02, 0.02) * size;      // short of the beginning, or past it
    const double sideways = random.between(-0.02, 0.02) * size;  // at the end, growing evenly
    const double start = random.between(0, 6.28);
    const double turns = 1 + miss / (size * flat * 3.14159265);
    const std::size_t count = 20 + random.below(300);
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(count - 1);
      const double angle = start + 6.28318530718 * turns * t;
      const double radius = size / 2 + sideways * t;
      places.emplace_back(radius * std::cos(angle), flat * radius * std::sin(angle));
    }
    INFO(seed << " size " << size << " miss " << miss << " sideways " << sideways);
    CHECK(ends_meet(test::stroke_through(places, "s").samples));
  }
}

TEST_CASE("outlines of limbs and arcs that stop where something else passes before them stay open") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    const double length = random.between(60, 500);
    const double width = random.between(16, 120);
    std::vector<Vec2> limb;  // along one side, round its tip, and back
    for (int k = 0; k <= 40; ++k) limb.emplace_back(length * k / 40, width / 2);
    for (int k = 1; k < 20; ++k) {
      const double angle = 3.14159265358979 * (0.5 - k / 20.0);
      limb.emplace_back(length + width / 2 * std::cos(angle), width / 2 * std::sin(angle));
    }
    for (int k = 40; k >= 0; --k) limb.emplace_back(length * k / 40, -width / 2);
    INFO(seed << " length " << length << " width " << width);
    CHECK(!ends_meet(test::stroke_through(limb, "limb").samples));

    const double radius = random.between(60, 400);
    const double bar = std::max(14.0, random.between(0.12, 0.6) * radius);  // that passes before a ring
    std::vector<Vec2> arc;
    const double open = bar / radius;
    for (int k = 0; k <= 150; ++k) {
      const double angle = open / 2 + (2 * 3.14159265358979 - open) * k / 150;
      arc.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    INFO("radius " << radius << " bar " << bar);
    CHECK(!ends_meet(test::stroke_through(arc, "arc").samples));
  }
}

}  // namespace
}  // namespace croquis
