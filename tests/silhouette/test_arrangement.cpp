// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/figure/arrangement.h"
#include "algorithms/silhouette/figure/labelling.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

ContourPath closed_path(Points points) {
  ContourPath path;
  path.segments.assign(points.size(), {true, true, 0, 0});
  path.points = std::move(points);
  return path;
}

Points circle(const Vec2& centre, double radius, int count = 60) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.123) / count;
    points.emplace_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

Arrangement crossed(std::vector<ContourPath> paths, double merging = 0.15) {
  Arrangement closed;
  closed.paths = std::move(paths);
  return cross_contours(std::move(closed), {}, 5, merging);
}

/// Crossings by testing every pair of segments.
int count_crossings(const std::vector<ContourPath>& paths) {
  struct Segment {
    Vec2 a, b;
  };
  std::vector<Segment> all;
  for (const ContourPath& path : paths) {
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      all.push_back({path.points[i], path.points[(i + 1) % path.points.size()]});
    }
  }
  int count = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) count += segments_cross(all[i].a, all[i].b, all[k].a, all[k].b);
  }
  return count;
}

}  // namespace

TEST_CASE("crossings are found as by testing all pairs, each contour passing through its own") {
  test::Random random(4);
  for (int round = 0; round < 20; ++round) {
    std::vector<ContourPath> paths;
    const std::uint32_t count = 1 + random.below(6);
    for (std::uint32_t i = 0; i < count; ++i) {
      paths.push_back(
          closed_path(circle({random.between(0, 100), random.between(0, 100)}, random.between(10, 60), 40)));
    }
    for (const double merging : {0.15, 1e-4}) {
      const Arrangement made = crossed(paths, merging);
      CHECK(static_cast<int>(made.contour_crossings.size()) == count_crossings(paths));
      for (Index k = 0; k < made.contour_crossings.size(); ++k) {
        for (const ContourCrossing::Strand& strand : made.contour_crossings[k].strands) {
          CHECK(made.contours[strand.contour].vertices[strand.position] == k);
        }
      }
    }
  }
}

TEST_CASE("two crossing discs have three faces with the right windings and areas") {
  Arrangement made = crossed({closed_path(circle({0, 0}, 50)), closed_path(circle({50, 0}, 50))});
  CHECK(made.contour_crossings.size() == 2);
  CHECK(made.arcs.size() == 4);
  find_faces(made);
  REQUIRE(made.conflicts.empty());
  REQUIRE(made.winding.size() == 4);
  CHECK(made.winding[0] == std::vector<int>{0, 0});
  const double lens = 2500 * (2 * std::numbers::pi / 3 - std::sqrt(3.0) / 2);
  for (std::size_t f = 1; f < 4; ++f) {
    const bool both = made.winding[f] == std::vector<int>{1, 1};
    CHECK(made.area[f] == Approx(both ? lens : 2500 * std::numbers::pi - lens).epsilon(0.01));
  }
}

TEST_CASE("nested contours are wound without crossing anything") {
  Points inner = circle({0, 0}, 20);
  std::reverse(inner.begin(), inner.end());
  Arrangement made = crossed({closed_path(circle({0, 0}, 50)), closed_path(inner)});
  find_faces(made);
  REQUIRE(made.winding.size() == 3);
  for (std::size_t f = 1; f < 3; ++f) {
    const bool ring = made.area[f] > 5000;
    CHECK(made.winding[f] == (ring ? std::vector<int>{1, 0} : std::vector<int>{1, -1}));
  }
}

TEST_CASE("contours that lie on one another are a conflict, not a crash") {
  const Points points = circle({0, 0}, 50);
  Arrangement made = crossed({closed_path(points), closed_path(points)});
  find_faces(made);
  CHECK_FALSE(made.conflicts.empty());
}

TEST_CASE("turning numbers count the turns of a loop") {
  const auto turning_number = [](const Points& points) {
    return std::lround(turning_of(points, true) / (2 * std::numbers::pi));
  };
  Points loop = circle({0, 0}, 10);
  CHECK(turning_number(loop) == 1);
  std::reverse(loop.begin(), loop.end());
  CHECK(turning_number(loop) == -1);
  Points eight;
  Points twice;
  for (int i = 0; i < 100; ++i) {
    const double t = 2 * std::numbers::pi * (i + 0.3) / 100;
    eight.emplace_back(std::sin(t), std::sin(2 * t));
    twice.emplace_back((1 + 2 * std::cos(t)) * std::cos(t), (1 + 2 * std::cos(t)) * std::sin(t));
  }
  CHECK(turning_number(eight) == 0);
  CHECK(turning_number(twice) == 2);
}

TEST_CASE("blame is found exactly where there is no labelling") {
  test::Random random(11);
  int possible = 0, impossible = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<ContourPath> paths;
    for (int i = 0; i < 3; ++i) {
      paths.push_back(closed_path(circle({random.between(-40, 40), random.between(-40, 40)}, random.between(30, 60))));
      paths.back().side = random.below(8) == 0 ? -1 : 1;
    }
    Arrangement made = crossed(paths);
    for (ContourCrossing& crossing : made.contour_crossings) {
      crossing.over = std::array{Index{0}, Index{0}, Index{1}, no_index}[random.below(4)];
    }
    if (random.below(3) > 0) std::ranges::fill(made.may_be_covered, std::uint8_t{1});
    find_faces(made);
    if (!made.conflicts.empty()) continue;
    const Labelling full = label_arrangement(made, LabellingRules::Full);
    const Labelling blamed = label_arrangement(made, LabellingRules::Blame);
    const bool any = !blamed.wrong_arcs.empty() || !blamed.wrong_crossings.empty() || !blamed.wrong_faces.empty();
    INFO("round " << round);
    REQUIRE(blamed.side.size() == paths.size());
    CHECK(any == full.side.empty());
    ++(any ? impossible : possible);
  }
  CHECK(std::min(possible, impossible) >= 8);
}
