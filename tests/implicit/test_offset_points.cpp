// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/implicit/offset_points.h"
#include "implicit/sample_points.h"

namespace croquis::implicit {
namespace {

OffsetOptions at(double distance) {
  OffsetOptions options;
  options.distance = distance;
  return options;
}

TEST_CASE("a lone surface has offset points on both sides at the full distance") {
  const Constraints sphere = test::sphere_points(400, Vec3::Zero(), 1);
  const OffsetPoints points = with_offset_points(sphere.positions, sphere.gradients, at(0.05));
  REQUIRE(points.constraints.size() == 3 * 400);
  CHECK(points.shortened == 0);
  CHECK(points.dropped == 0);
  for (std::size_t i = 0; i < points.constraints.size(); ++i)
    CHECK(points.constraints.positions[i].norm() - 1 == Approx(points.constraints.values[i]).margin(1e-12));
}

TEST_CASE("between sheets nearer than an edge offsets are halved until they stay on their own half") {
  const int side = 12;
  const double gap = 0.4;  // of the edge length 1
  std::vector<Vec3> positions, normals;
  for (int sheet = 0; sheet < 2; ++sheet) {
    for (int i = 0; i < side * side; ++i) {
      positions.emplace_back(i % side, i / side, sheet * gap);
      normals.emplace_back(0, 0, sheet == 0 ? -1 : 1);  // a thin wall
    }
  }
  const OffsetPoints points = with_offset_points(positions, normals, at(0.5));
  CHECK(points.constraints.size() - positions.size() + points.dropped == 2 * positions.size());
  CHECK(points.shortened == positions.size());  // the inner side of every point, and no outer one
  for (std::size_t k = 0; k < points.origins.size(); ++k) {
    const Vec3& place = points.constraints.positions[positions.size() + k];
    const double value = points.constraints.values[positions.size() + k];
    const Index origin = points.origins[k];
    if (value < 0) CHECK(std::abs(value) <= 0.2);
    const double own = std::abs(place.z() - positions[origin].z());
    const double other = std::abs(place.z() - positions[(origin + side * side) % positions.size()].z());
    CHECK(own <= other * (1 + 1e-12));
    CHECK((place - (positions[origin] + value * normals[origin])).norm() < 1e-12);
  }
}

TEST_CASE("an offset that never becomes free is dropped, never kept") {
  // The second point lies 1/40 above the first; a step of 1, six times halved, is 1/64: still past the middle.
  const std::vector<Vec3> positions = {Vec3::Zero(), Vec3(0, 0, 0.025)};
  const std::vector<Vec3> normals = {Vec3::UnitZ(), Vec3::UnitZ()};
  const OffsetPoints points = with_offset_points(positions, normals, at(1));
  CHECK(points.dropped == 2);  // up from the lower one, down from the upper one
  CHECK(points.origins == std::vector<Index>{0, 1});
  CHECK(points.constraints.values == std::vector<double>{0, 0, -1, 1});
}

TEST_CASE("one side alone, points without normals, and bad input") {
  const Constraints sphere = test::sphere_points(50, Vec3::Zero(), 1);
  OffsetOptions outside = at(0.1);
  outside.both_sides = false;
  std::vector<Vec3> normals = sphere.gradients;
  normals[3] = Vec3::Zero();
  const OffsetPoints points = with_offset_points(sphere.positions, normals, outside);
  CHECK(points.constraints.size() == 99);
  for (const double value : points.constraints.values) CHECK(value >= 0);
  CHECK_THROWS_AS(with_offset_points(sphere.positions, normals, at(0)), Error);
  CHECK_THROWS_AS(with_offset_points(sphere.positions, std::span(normals).first(7), at(1)), Error);
}

}  // namespace
}  // namespace croquis::implicit
