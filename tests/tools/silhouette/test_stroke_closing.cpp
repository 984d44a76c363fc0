// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/tools/silhouette/stroke_edit.h"
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
  CHECK(ends_meet(arc(1.0, 5)));  // an eye
  CHECK(!ends_meet(arc(1.0, 2)));
  CHECK(!ends_meet(test::stroke_through({{0, 0}, {10, 6}, {22, 0}, {12, 1}, {6, -1}}, "tick").samples));
  CloseOptions zoomed;
  zoomed.units_per_pixel = 0.1;
  CHECK(ends_meet(arc(1.0, 2), zoomed));
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

TEST_CASE("loops close with a gap or an overlap up to five percent of their length, and ends three percent aside") {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    test::Random random(seed);
    const double radius = random.between(20, 450);
    const double length = 2 * 3.14159265358979 * radius;
    const double miss = random.between(-0.05, 0.05);
    const double aside = random.between(-0.03, 0.03) * length;
    const double start = random.between(0, 6.28);
    const std::size_t count = 40 + random.below(200);
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(count - 1);
      const double angle = start + 2 * 3.14159265358979 * (1 + miss) * t;
      places.push_back((radius + aside * (t - 0.5)) * Vec2(std::cos(angle), std::sin(angle)) +
                       test::jitter(random, 0.0015 * length));
    }
    INFO(seed << " radius " << radius << " miss " << miss << " aside " << aside / length);
    CHECK(ends_meet(test::stroke_through(places, "s").samples));
  }
}

TEST_CASE("spirals stay open, however long they are") {
  for (const double turns : {2.0, 3.3, 5.0, 9.5}) {
    std::vector<Vec2> spiral;
    const int count = static_cast<int>(turns * 120);
    for (int k = 0; k <= count; ++k) {
      const double angle = 2 * 3.14159265358979 * turns * k / count;
      spiral.emplace_back((40 + 180.0 * k / count) * Vec2(std::cos(angle), std::sin(angle)));
    }
    INFO(turns);
    CHECK(!ends_meet(test::stroke_through(spiral, "s").samples));
  }
}

TEST_CASE("outlines that begin at a corner close where their ends head for it or run across each other") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    const double size = random.between(80, 700);
    const double half = random.between(0.45, 1.3);  // of the corner's angle
    const Vec2 left = size * Vec2(-std::sin(half), std::cos(half));
    const Vec2 right = size * Vec2(std::sin(half), std::cos(half));
    const double length = 2 * size + (left - right).norm();
    const double begin = random.between(-0.02, 0.02) * length / size;  // short of the corner, or beyond it
    const double end = random.between(-0.02, 0.02) * length / size;
    std::vector<Vec2> places;
    for (int k = 0; k <= 60; ++k) places.push_back((begin + (1 - begin) * k / 60) * left);
    for (int k = 1; k < 60; ++k) places.push_back(left + k / 60.0 * (right - left));
    for (int k = 0; k <= 60; ++k) places.push_back((1 + (end - 1) * k / 60) * right);
    INFO(seed << " size " << size << " half angle " << half << " begin " << begin << " end " << end);
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
    const double bar = random.between(0.36, 0.6) * radius;  // that passes before a ring
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
