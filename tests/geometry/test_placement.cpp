// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/geometry/placement.h"
#include "support/random.h"

using namespace croquis;

namespace {

Vec3 random_vector(test::Random& random, double low, double high) {
  return {random.between(low, high), random.between(low, high), random.between(low, high)};
}

/// The same from Eigen's own rotations.
Affine3 reference(const Placement& placement) {
  const auto turn = [&](int axis) {
    return Eigen::AngleAxisd(placement.rotation(axis) * M_PI / 180, Vec3::Unit(axis)).toRotationMatrix();
  };
  return {turn(2) * turn(1) * turn(0) * placement.scale.asDiagonal(), placement.position};
}

}  // namespace

TEST_CASE("a placement scales, then turns about x, y and z, then moves; right angles are exact") {
  test::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Placement placement{random_vector(random, -9, 9), random_vector(random, -400, 400),
                              random_vector(random, 0.1, 5)};
    CHECK((placement.map().linear - reference(placement).linear).norm() < 1e-12);
    CHECK(placement.map().offset == placement.position);
  }
  CHECK(Placement().map().is_identity());
  const Affine3 quarter = Placement{{0, 0, 0}, {0, 0, 90}, {2, 3, 4}}.map();
  CHECK(quarter({1, 0, 0}) == Vec3(0, 2, 0));
  CHECK(quarter({0, 1, 0}) == Vec3(-3, 0, 0));
  CHECK(rotation_matrix({720, -450, 180}) == rotation_matrix({0, 270, 180}));
}

TEST_CASE("angles read from a rotation give that rotation, upright ones too") {
  test::Random random(2);
  for (int i = 0; i < 200; ++i) {
    Vec3 degrees = random_vector(random, -180, 180);
    if (i % 4 == 0) degrees.y() = i % 8 == 0 ? 90 : -90;
    const Eigen::Matrix3d rotation = rotation_matrix(degrees);
    const Vec3 read = rotation_degrees(rotation);
    CHECK((rotation_matrix(read) - rotation).norm() < 1e-9);
    CHECK(std::abs(read.y()) <= 90);
  }
}

TEST_CASE("a placement moved by a map is where the map puts it; scaling never shears") {
  test::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const Placement start{random_vector(random, -3, 3), random_vector(random, -180, 180),
                          random_vector(random, 0.2, 3)};
    const Affine3 rigid = Placement{random_vector(random, -3, 3), random_vector(random, -180, 180), Vec3::Ones()}.map();
    const Affine3 both = composed(rigid, start.map());
    CHECK((moved(start, rigid).map().linear - both.linear).norm() < 1e-9);
    CHECK((moved(start, rigid).position - both.offset).norm() < 1e-9);

    const Affine3 stretch{Vec3(2, 1, 0.5).asDiagonal(), Vec3::Zero()};
    const Placement stretched = moved(start, stretch);
    CHECK(stretched.rotation == start.rotation);
    // Each of its own axes is as long as the map makes it.
    for (int axis = 0; axis < 3; ++axis) {
      const double length = (stretch.linear * start.map().linear.col(axis)).norm();
      CHECK(stretched.map().linear.col(axis).norm() == Approx(length));
    }
  }
  const Placement plain{{1, 2, 3}, {0, 0, 0}, {1, 1, 1}};
  CHECK(moved(plain, {Vec3(2, 1, 0.5).asDiagonal(), {1, 0, 0}}) == Placement{{3, 2, 1.5}, {0, 0, 0}, {2, 1, 0.5}});
}

TEST_CASE("a point can be kept where it is; the box around a turned box holds its corners") {
  const Placement before{{1, 2, 3}, {10, 20, 30}, {1, 2, 3}};
  const Vec3 point(4, 5, 6);
  Placement changed = before;
  changed.rotation = {70, -20, 5};
  changed.scale = {2, 2, 2};
  const Placement kept = with_point_kept(changed, before, point);
  CHECK((kept.map()(point) - before.map()(point)).norm() < 1e-12);
  CHECK(kept.rotation == changed.rotation);

  const auto box = transformed(std::array<Vec3, 2>{Vec3(0, 0, 0), Vec3(1, 2, 3)}, before.map());
  Vec3 low = Vec3::Constant(1e9), high = -low;
  for (const double x : {0, 1}) {
    for (const double y : {0, 2}) {
      for (const double z : {0, 3}) {
        low = low.cwiseMin(before.map()({x, y, z}));
        high = high.cwiseMax(before.map()({x, y, z}));
      }
    }
  }
  CHECK((box[0] - low).norm() + (box[1] - high).norm() < 1e-12);
}

TEST_CASE("placements of no or endless size are invalid") {
  CHECK(is_valid(Placement()));
  CHECK_FALSE(is_valid({{0, 0, 0}, {0, 0, 0}, {1, 0, 1}}));
  CHECK_FALSE(is_valid({{0, 0, 0}, {0, 0, 0}, {1, -1, 1}}));
  CHECK_FALSE(is_valid({{0, 0, 1e31}, {0, 0, 0}, {1, 1, 1}}));
  CHECK_FALSE(is_valid({{0, 0, 0}, {std::nan(""), 0, 0}, {1, 1, 1}}));
}
