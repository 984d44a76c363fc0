// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "implicit/octree.h"
#include "implicit/sample_points.h"

namespace croquis::implicit {
namespace {

const Box cube = {Vec3::Constant(-1.5), Vec3::Constant(1.5)};

TEST_CASE("leaves hold all points, few each, and fill the cube") {
  const std::vector<Vec3> points = test::sphere_points(2000, Vec3::Zero(), 1).positions;
  const Octree tree(points, cube, {40, 20, {}, false});
  std::set<Index> seen;
  double volume = 0;
  for (const Octree::Leaf& leaf : tree.leaves()) {
    CHECK(leaf.point_count() <= 40);
    volume += leaf.cube.size().prod();
    for (std::size_t i = leaf.begin; i < leaf.end; ++i) {
      CHECK(leaf.cube.contains(points[tree.order()[i]]));
      seen.insert(tree.order()[i]);
    }
  }
  CHECK(seen.size() == points.size());
  CHECK(volume == Approx(27));
}

TEST_CASE("leaves near a place are all those whose grown cubes hold it") {
  const std::vector<Vec3> points = test::sphere_points(1500, Vec3::Zero(), 1).positions;
  const Octree tree(points, cube, {20, 20, {}, false});
  std::vector<Vec3> places = test::random_points(200, 51);
  for (Vec3& place : places) place *= 1.8;
  places.push_back(Vec3::Zero());
  places.push_back(Vec3(0.375, 0.75, 0));
  for (const double overlap : {0.0, 0.1, 0.25, 1.0}) {
    for (const Vec3& place : places) {
      std::set<Index> found;
      tree.for_each_near(place, overlap, [&](Index leaf) { CHECK(found.insert(leaf).second); });
      for (Index leaf = 0; leaf < tree.leaves().size(); ++leaf)
        if (tree.leaves()[leaf].cube.grown(overlap * 0.999).contains(place)) CHECK(found.contains(leaf));
      const Index home = tree.leaf_at(place);
      CHECK((home == no_index) == !cube.contains(place));
      if (home != no_index) CHECK(tree.leaves()[home].cube.contains(place));
    }
  }
}

TEST_CASE("a thousand points at one place end the cutting at the depth allowed") {
  const std::vector<Vec3> points(1000, Vec3(0.1, 0.2, 0.3));
  const Octree tree(points, cube, {40, 20, {}, false});
  CHECK(tree.leaves().size() == 20 * 7 + 1);
}

TEST_CASE("equal leaves have one size wherever there are points") {
  const std::vector<Vec3> points = test::ellipsoid_points(3000, Vec3(1, 0.5, 0.2)).positions;
  const Octree tree(points, cube, {40, 20, {}, true});
  std::set<double> sizes;
  std::size_t used = 0;
  for (const Octree::Leaf& leaf : tree.leaves()) {
    if (leaf.point_count() == 0) continue;
    sizes.insert(leaf.cube.size().x());
    ++used;
  }
  CHECK(sizes.size() == 1);
  CHECK(points.size() <= 40 * used);
}

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
