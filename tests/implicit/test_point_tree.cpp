// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include <catch2/catch.hpp>

#include "croquis/implicit/point_tree.h"
#include "implicit/sample_points.h"

namespace croquis::implicit {
namespace {

std::vector<Index> by_distance(const std::vector<Vec3>& points, const Vec3& place) {
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const double da = (points[a] - place).squaredNorm();
    const double db = (points[b] - place).squaredNorm();
    return da != db ? da < db : a < b;
  });
  return order;
}

TEST_CASE("nearest points are those of a full search, ties by index") {
  std::vector<Vec3> points = test::random_points(700, 31);
  for (std::size_t i = 0; i < 300; ++i)  // many equal distances: a lattice, and points that come twice
    points.push_back(Vec3(static_cast<double>(i % 5), static_cast<double>(i / 5 % 5), static_cast<double>(i / 50)) /
                         2.5 -
                     Vec3::Ones());
  const PointTree tree(points);
  std::vector<Vec3> places = test::random_points(60, 32);
  for (std::size_t i = 0; i < 20; ++i) places.push_back(points[700 + 7 * i]);
  for (const Vec3& place : places) {
    const std::vector<Index> expected = by_distance(points, place);
    CHECK(tree.nearest(place) == expected.front());
    for (const std::size_t count :
         {std::size_t{1}, std::size_t{2}, std::size_t{30}, points.size(), points.size() + 5}) {
      const std::vector<Index> found = tree.nearest(place, count);
      CHECK(found == std::vector<Index>(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(
                                                                                 std::min(count, points.size()))));
    }
  }
}

TEST_CASE("points in a box are those of a full search, ascending, and counted as far as asked") {
  const std::vector<Vec3> points = test::random_points(1000, 33);
  const PointTree tree(points);
  const std::vector<Vec3> corners = test::random_points(100, 34);
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Box box = bounds(std::span(corners).subspan(i, 2));
    std::vector<Index> expected;
    for (Index p = 0; p < points.size(); ++p)
      if (box.contains(points[p])) expected.push_back(p);
    CHECK(tree.inside(box) == expected);
    for (const std::size_t most : {std::size_t{0}, std::size_t{7}, expected.size(), expected.size() + 1})
      CHECK(tree.holds_more_than(most, box) == (expected.size() > most));
    if (!expected.empty()) CHECK(tree.holds_more_than(expected.size() - 1, box));
  }
  CHECK(tree.inside({points[3], points[3]}) == std::vector<Index>{3});
}

TEST_CASE("a tree without points, or with one place many times, answers") {
  const PointTree none(std::span<const Vec3>{});
  CHECK(none.nearest(Vec3::Zero()) == no_index);
  CHECK(none.nearest(Vec3::Zero(), 3).empty());
  CHECK(none.inside({-Vec3::Ones(), Vec3::Ones()}).empty());
  CHECK_FALSE(none.holds_more_than(0, {-Vec3::Ones(), Vec3::Ones()}));
  const PointTree same(std::vector<Vec3>(50, Vec3(1, 2, 3)));
  CHECK(same.nearest(Vec3::Zero()) == 0);
  CHECK(same.nearest(Vec3::Zero(), 3) == std::vector<Index>{0, 1, 2});
}

}  // namespace
}  // namespace croquis::implicit
