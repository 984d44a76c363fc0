// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/strokes/polyline.h"

using namespace croquis;
using namespace croquis::silhouette;

TEST_CASE("a length along a line leads to the same place from either of its ends") {
  const Points line{{0, 0}, {3, 0}, {3, 4}, {9, 4}};  // 13 long
  for (const double along : {0.5, 3.0, 5.0, 7.0, 12.0}) {
    INFO(along);
    const double parameter = parameter_along(line, true, along);
    CHECK(parameter_along(line, false, 13 - along) == Approx(parameter));
    const Vec2 place = point_at(line, parameter);
    CHECK((place - line[0]).lpNorm<1>() == Approx(along));  // it only goes right and up
    CHECK(nearest_on_line(line, place, 0, 3) == Approx(parameter));
  }
  CHECK(parameter_along(line, true, 20) == 3);
  CHECK(parameter_along(line, false, 20) == 0);
}

TEST_CASE("the nearest place is looked for in the given segments, the closing one among them") {
  const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  CHECK(nearest_on_line(square, {-1, 1}, 0, 4) == Approx(3.75));
  CHECK(nearest_on_line(square, {-1, 1}, 0, 3) == Approx(0));
  CHECK(nearest_on_line(square, {1, -1}, 1, 2) == Approx(1));
}

TEST_CASE("an end meets a segment that it runs across, heads for, or lies beside") {
  const Points back{{0, 0}, {-2, 0}, {-4, 0}};
  const std::array headings{Vec2(1, 0)};
  const auto check = [&](double x, EndHit::Way way, double along) {
    INFO(x);
    const std::vector<EndHit> hits = end_hits(back, headings, 6, {x, -1}, {x, 2});
    REQUIRE(hits.size() == 2);
    CHECK(hits[0].way == way);
    CHECK(hits[0].along == Approx(along));
    CHECK((hits[0].at - Vec2(x, 0)).norm() < 1e-12);
    CHECK(hits[1].way == EndHit::Way::Beside);
    CHECK(hits[1].along == Approx(std::abs(x)));
  };
  check(-3, EndHit::Way::Across, -3);
  check(5, EndHit::Way::Ahead, 5);
  CHECK(end_hits(back, headings, 6, {7, -1}, {7, 2}).size() == 1);
}
