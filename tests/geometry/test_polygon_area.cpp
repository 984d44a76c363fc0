// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/polyline.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// A star-shaped polygon around the origin.
std::vector<Vec2> star(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    points.push_back(random.between(0.3, 1) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return points;
}

}  // namespace

TEST_CASE("the area normal of a flat polygon is the plane's, as long as the area that the shoelace formula gives") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<Vec2> flat = star(seed, 3 + seed);
    Random random(seed);
    const Vec3 normal = Vec3(random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1)).normalized();
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
    std::vector<Vec3> polygon;
    for (const Vec2& point : flat) polygon.push_back(Vec3(10, -20, 30) + point.x() * u + point.y() * v);
    const Vec3 expected = signed_area(flat) * normal;
    CHECK((area_normal(polygon) - expected).norm() < 1e-12);
  }
}

TEST_CASE("places, indices and faces give the same, and the area normals of a closed mesh add up to nothing") {
  for (const PolyMesh& mesh : {cube(), uv_sphere(9, 6), torus(8, 5), triangulated(double_torus())}) {
    Vec3 sum = Vec3::Zero();
    for (Index face = 0; face < mesh.face_count(); ++face) {
      std::vector<Vec3> polygon;
      for (const Index vertex : mesh.face(face)) polygon.push_back(mesh.positions[vertex]);
      CHECK(area_normal(mesh, face) == area_normal(polygon));
      CHECK(area_normal(mesh, face) == area_normal(mesh.positions, mesh.face(face)));
      sum += area_normal(mesh, face);
    }
    CHECK(sum.norm() < 1e-12);
  }
}

TEST_CASE("what has fewer than three corners has no area") {
  const std::vector<Vec3> line = {{0, 0, 0}, {1, 2, 3}};
  CHECK(area_normal(line).isZero(0));
  CHECK(area_normal(std::vector<Vec3>()).isZero(0));
}
