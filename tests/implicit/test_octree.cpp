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

}  // namespace
}  // namespace croquis::implicit
