// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_report.h"
#include "croquis/implicit/slab_polygonizer.h"
#include "implicit/sample_fields.h"
#include "support/difference_field.h"

namespace croquis::implicit {
namespace {

using namespace croquis::test;

PolyMesh mesh_of(const LayeredMesh& made) {
  PolyMesh mesh;
  mesh.positions = made.positions;
  for (std::size_t c = 0; c < made.corners.size(); c += 3)
    mesh.add_triangle(made.corners[c], made.corners[c + 1], made.corners[c + 2]);
  return mesh;
}

using Corner = std::array<double, 3>;

/// Triangles by their corners' places, each from its least corner: what doesn't depend on any order.
std::vector<std::array<Corner, 3>> triangles_of(const PolyMesh& mesh) {
  std::vector<std::array<Corner, 3>> triangles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::array<Corner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = mesh.positions[mesh.face(f)[i]];
      corners[i] = {p.x(), p.y(), p.z()};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Points around a torus of radii 1 and 0.4.
std::vector<Vec3> seeds_on_torus(int count) {
  std::vector<Vec3> seeds;
  for (int i = 0; i < count; ++i) {
    const double around = 2 * std::numbers::pi * i / count, aside = 17.0 * around;
    const double radius = 1 + 0.4 * std::cos(aside);
    seeds.emplace_back(radius * std::cos(around), radius * std::sin(around), 0.4 * std::sin(aside));
  }
  return seeds;
}

}  // namespace

TEST_CASE("slab by slab the same surface comes out as at once, along every axis, the same bits for any slabs") {
  const Field field = field_of([](const Vec3& p) { return torus_at(p, 1, 0.4); }, 1e-6);
  const std::vector<Vec3> seeds = seeds_on_torus(2000);
  const PolygonizerOptions options = within(2, 0.031, 0);
  Progress progress;
  const Polygonized whole = polygonize(field, seeds, options, progress);
  for (const int axis : {0, 1, 2}) {
    CAPTURE(axis);
    std::vector<Vec3> positions;
    std::vector<Index> corners;
    for (const std::size_t points : {5000U, 900U, 300U, 1U}) {
      Progress sweeping;
      const SlabPolygonized result = polygonize_by_slabs(field, seeds, options, {axis, points}, {}, sweeping);
      CHECK(result.report.complete());
      CHECK(result.report.cells == whole.cells);
      if (points == 5000) {
        CHECK(result.slabs == 1);
        positions = result.made.positions;
        corners = result.made.corners;
        CHECK(triangles_of(mesh_of(result.made)) == triangles_of(whole.mesh));
      } else {
        CHECK(result.slabs > 1);
        CHECK(result.most_bytes < whole.bytes);
      }
      CHECK(result.made.positions == positions);
      CHECK(result.made.corners == corners);
    }
  }
}

TEST_CASE("a surface that leads back through many slabs is found whole") {
  // A column with seeds all along, and beside it one with a seed at its top alone.
  const Vec3 first(-0.7, 0, 0), second(0.7, 0, 0), radii(0.4, 0.4, 1.8);
  const Field field = field_of(
      [&](const Vec3& p) {
        return std::min(ellipsoid_at(Vec3(p - first), radii), ellipsoid_at(Vec3(p - second), radii));
      },
      1e-6);
  std::vector<Vec3> seeds = {Vec3(0.7, 0, 1.8)};
  for (int i = 0; i <= 1000; ++i) {
    const double angle = std::numbers::pi * (i / 1000.0);
    seeds.emplace_back(Vec3(first.x() + 0.4 * std::sin(angle), 0, 1.8 * std::cos(angle)));
  }
  const PolygonizerOptions options = within(2, 0.031, 0);
  int begun_anew = 0;
  SlabEvents events;
  events.begun_anew = [&] { ++begun_anew; };
  Progress progress, again;
  const SlabPolygonized result = polygonize_by_slabs(field, seeds, options, {2, 100}, events, progress);
  CHECK(begun_anew > 0);
  const SlabPolygonized whole = polygonize_by_slabs(field, seeds, options, {2, 10000}, {}, again);
  CHECK(result.made.positions == whole.made.positions);
  CHECK(result.made.corners == whole.made.corners);
  const MeshReport report = inspect(mesh_of(result.made), false, progress);
  CHECK(report.closed);
  CHECK(report.components == 2);
}

TEST_CASE("slabs are entered in order, and finished layers never change") {
  const Field field = field_of([](const Vec3& p) { return torus_at(p, 1, 0.4); }, 1e-6);
  const std::vector<Vec3> seeds = seeds_on_torus(2000);
  double before = -std::numeric_limits<double>::infinity();
  std::vector<Index> corners;
  SlabEvents events;
  events.enter = [&](double low, double high, Progress&) {
    CHECK(low >= before);
    CHECK(high > low);
    before = low;
  };
  events.finished = [&](LayeredMesh& made, Progress&) {
    REQUIRE(made.first_vertices.size() == made.first_corners.size());
    CHECK(made.first_corners.back() == made.corners.size());
    CHECK(made.first_vertices.back() <= made.positions.size());
    REQUIRE(made.corners.size() >= corners.size());
    CHECK(std::equal(corners.begin(), corners.end(), made.corners.begin()));
    corners = made.corners;
    for (const Index corner : corners) CHECK(corner < made.positions.size());
  };
  Progress progress;
  const SlabPolygonized result = polygonize_by_slabs(field, seeds, within(2, 0.1, 0), {0, 200}, events, progress);
  CHECK(result.slabs > 3);
  CHECK(corners.size() == result.made.corners.size());
}

}  // namespace croquis::implicit
