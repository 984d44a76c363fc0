// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "implicit/sample_points.h"
#include "implicit/thinning.h"

namespace croquis::implicit {
namespace {

TEST_CASE("thinning keeps at most so many, evenly, whatever the order of the candidates") {
  const std::vector<Vec3> points = test::sphere_points(3000, Vec3::Zero(), 1).positions;
  const Box box = bounds(points);
  std::vector<Index> candidates(points.size());
  for (Index i = 0; i < points.size(); ++i) candidates[i] = i;
  const std::vector<Index> kept = thinned(points, candidates, box, 300);
  CHECK(kept.size() <= 300);
  CHECK(kept.size() >= 200);
  CHECK(std::is_sorted(kept.begin(), kept.end()));
  double gap = 0;  // of the farthest point to its nearest kept one
  for (const Vec3& point : points) {
    double nearest = 9;
    for (const Index k : kept) nearest = std::min(nearest, (points[k] - point).norm());
    gap = std::max(gap, nearest);
  }
  CHECK(gap < 0.35);  // 300 points of a sphere lie about 0.2 apart

  std::reverse(candidates.begin(), candidates.end());
  CHECK(thinned(points, candidates, box, 300) == kept);
  std::rotate(candidates.begin(), candidates.begin() + 1111, candidates.end());
  CHECK(thinned(points, candidates, box, 300) == kept);
}

TEST_CASE("few candidates stay, and points at one place don't hang") {
  const std::vector<Vec3> points = test::random_points(20, 41);
  CHECK(thinned(points, {7, 3, 5}, bounds(points), 3) == std::vector<Index>{3, 5, 7});
  const std::vector<Vec3> same(10, Vec3::Ones());
  CHECK(thinned(same, {0, 1, 2, 3, 4}, bounds(same), 2) == std::vector<Index>{0, 1});
  CHECK(thinned(same, {4, 1, 2, 3, 0}, {Vec3::Zero(), Vec3::Constant(2)}, 2) == std::vector<Index>{0});
}

}  // namespace
}  // namespace croquis::implicit
