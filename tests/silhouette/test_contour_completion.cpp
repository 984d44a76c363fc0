// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/figure/contour_completion.h"

using namespace croquis;
using namespace croquis::silhouette;
using std::numbers::pi;

namespace {

const CompletionOptions lengths_only{1, 0, 40, 400};
const CompletionOptions bending_only{0, 1, 40, 400};

/// A U-turn of width d, opening downwards, from left to right: it turns right.
std::array<Vec2, 4> u_turn(double d) { return completion_curve({0, 0}, {0, 1}, {d, 0}, {0, 1}); }

}  // namespace

TEST_CASE("a straight completion costs its length and no bending") {
  const auto curve = completion_curve({0, 0}, {1, 0}, {30, 0}, {-1, 0});
  CHECK(completion_cost(curve, 0, 10, lengths_only) == Approx(3));
  CHECK(completion_cost(curve, 0, 10, bending_only) == Approx(0).margin(1e-12));
  for (const Vec2& point : curve) CHECK(std::abs(point.y()) < 1e-12);
}

TEST_CASE("a U-turn is a half circle that costs 2 pi of bending at any size") {
  for (const double d : {1.0, 40.0, 900.0}) {
    const auto curve = u_turn(d);
    CHECK(completion_cost(curve, 0, d, lengths_only) == Approx(pi / 2).epsilon(0.02));
    CHECK(completion_cost(curve, 0, d, bending_only) == Approx(2 * pi).epsilon(0.05));
    for (const Vec2& point : completion_points(curve, {}, d / 50, {}, 0)) {
      CHECK((point - Vec2(d / 2, 0)).norm() == Approx(d / 2).epsilon(0.02));
    }
  }
}

TEST_CASE("bending away from the surface is dearer than bending round it") {
  const auto curve = u_turn(10);
  const double plain = completion_cost(curve, 0, 10, bending_only);
  CHECK(completion_cost(curve, -1, 10, bending_only) == Approx(plain));  // the surface lies inside the turn
  CHECK(completion_cost(curve, 1, 10, bending_only) > 2 * plain);
}

TEST_CASE("completions leave both ends along their tangents") {
  const Vec2 a(3, 4);
  const Vec2 b(50, -20);
  const Vec2 ta(std::cos(1.0), std::sin(1.0));
  const Vec2 tb(std::cos(2.5), std::sin(2.5));
  const auto curve = completion_curve(a, ta, b, tb);
  CHECK((curve[1] - a).normalized().dot(ta) == Approx(1));
  CHECK((curve[2] - b).normalized().dot(tb) == Approx(1));
  const Points points = completion_points(curve, {}, 2, {}, 0);
  CHECK(points.front() == a);
  CHECK((points.back() - b).norm() < 1e-12);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) CHECK((points[i + 1] - points[i]).norm() < 3.1);
}

TEST_CASE("lines with the surface on different sides are no candidates") {
  // Two parallel lines ending behind the same bar; walked outward through one and back along the other.
  std::vector<CleanLine> lines(2);
  for (int i = 0; i < 2; ++i) {
    auto& line = lines[static_cast<std::size_t>(i)];
    for (int k = 0; k <= 10; ++k) line.points.emplace_back(20.0 * i, 6.0 * k);
    line.stroke.assign(line.points.size(), static_cast<Index>(i));
    line.strokes = {static_cast<Index>(i)};
  }
  Junctions junctions;
  junctions.ends = {{0, false, 0, 0, {0, 60}, {0, 1}, 1}, {1, false, 0, 0, {20, 60}, {0, 1}, 1}};
  const auto count = [&](int first, int second) {
    junctions.sides = {first, second};
    return completion_candidates(lines, junctions, {0, 1}, {}).size();
  };
  CHECK(count(1, -1) == 1);
  CHECK(count(1, 0) == 1);
  CHECK(count(1, 1) == 0);
  lines[0].object = "a";
  CHECK(count(1, -1) == 1);
  lines[1].object = "b";
  CHECK(count(1, -1) == 0);
}
