// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/implicit/local_fit.h"
#include "croquis/implicit/marching_cubes.h"
#include "implicit/sample_fields.h"
#include "implicit/sample_points.h"
#include "support/difference_field.h"
#include "support/random.h"

namespace croquis::implicit {
namespace {

using namespace croquis::test;

template <typename Function>
Polygonized surface_of(Function function, const std::vector<Vec3>& seeds, const PolygonizerOptions& options) {
  Progress progress;
  return polygonize(field_of(function, 1e-6), seeds, options, progress);
}

MeshReport report_of(const Polygonized& surface, bool intersections = false) {
  Progress progress;
  return inspect(surface.mesh, intersections, progress);
}

void check_closed(const Polygonized& surface, std::int64_t euler) {
  const MeshReport report = report_of(surface, surface.cells < 3000);
  CHECK(surface.complete());
  CHECK(report.closed);
  CHECK(report.oriented);
  CHECK(report.nonmanifold_edges == 0);
  CHECK(report.nonmanifold_vertices == 0);
  CHECK(report.degenerate_faces == 0);
  CHECK(report.self_intersections.value_or(0) == 0);
  CHECK(report.euler_characteristic == euler);
  CHECK(report.volume.value_or(-1) > 0);
  CHECK(validate(surface.mesh).empty());
}

TEST_CASE("spheres, tori and ellipsoids come out closed, outward, with their Euler numbers") {
  const auto sphere = [](const Vec3& p) { return sphere_at(p, Vec3(0.01, 0.02, 0.03), 1); };
  const auto torus = [](const Vec3& p) { return torus_at(p, 1, 0.4); };
  const auto ellipsoid = [](const Vec3& p) { return ellipsoid_at(p, Vec3(1, 0.6, 0.3)); };
  for (const double cell : {0.21, 0.1, 0.043}) {
    check_closed(surface_of(sphere, {Vec3(0, 0, 1)}, within(2, cell)), 2);
    check_closed(surface_of(torus, {Vec3(1.4, 0, 0)}, within(2, cell)), 0);
    check_closed(surface_of(ellipsoid, {Vec3(1, 0, 0)}, within(2, cell)), 2);
  }
}

TEST_CASE("a lattice through the surface's own symmetric places leaves no crack and no empty triangle") {
  // Values of exactly 0 at corners, whole planes of them.
  const auto cube = [](const Vec3& p) { return p.cwiseAbs().maxCoeff() - 1; };
  const auto octahedron = [](const Vec3& p) { return p.cwiseAbs().sum() - 1; };
  const auto sphere = [](const Vec3& p) { return p.squaredNorm() - 1; };
  for (const double cell : {0.5, 0.25, 0.125}) {
    check_closed(surface_of(cube, {Vec3(1, 0, 0)}, within(2, cell)), 2);
    check_closed(surface_of(octahedron, {Vec3(1, 0, 0)}, within(2, cell)), 2);
    check_closed(surface_of(sphere, {Vec3(1, 0, 0)}, within(2, cell)), 2);
  }
}

TEST_CASE("volume and distance come nearer with the square of the cell") {
  const auto torus = [](const Vec3& p) { return torus_at(p, 1, 0.4); };
  const double exact = 2 * M_PI * M_PI * 0.4 * 0.4;
  std::vector<double> volume_errors, distances;
  for (const double cell : {0.16, 0.08, 0.04, 0.02}) {
    const Polygonized surface = surface_of(torus, {Vec3(1.4, 0, 0)}, within(2, cell));
    volume_errors.push_back(std::abs(*report_of(surface).volume - exact));
    double sum = 0;
    for (const Vec3& p : surface.mesh.positions) sum += std::abs(torus(p));
    distances.push_back(sum / static_cast<double>(surface.mesh.positions.size()));
  }
  for (std::size_t i = 1; i < volume_errors.size(); ++i) {
    CHECK(volume_errors[i - 1] / volume_errors[i] > 3);
    CHECK(volume_errors[i - 1] / volume_errors[i] < 5);
    CHECK(distances[i - 1] / distances[i] > 3);
    CHECK(distances[i - 1] / distances[i] < 5);
  }
}

TEST_CASE("thin sheets with sharp edges stay closed at any resolution, even where the sheet is thinner than a cube") {
  for (const double thickness : {0.3, 0.1, 0.03}) {
    const auto shell = [&](const Vec3& p) { return pierced_shell_at(p, thickness); };
    for (const double cell : {0.17, 0.07, 0.031}) {
      const Polygonized surface =
          surface_of(shell, sphere_points(500, Vec3::Zero(), 1 + thickness / 2).positions, within(2, cell));
      const MeshReport report = report_of(surface);
      CHECK(surface.complete());
      CHECK(report.closed);
      CHECK(report.oriented);
      CHECK(report.nonmanifold_edges == 0);
      CHECK(report.nonmanifold_vertices == 0);
      if (cell < 0.7 * thickness) CHECK(report.euler_characteristic == 0);
    }
  }
}

TEST_CASE("random values at every corner, all signs and ambiguities: closed, oriented, manifold") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto noise = [seed](const Vec3& p) {
      // Nothing at the rim of the box, so that the surface is closed.
      const Vec3 cell = (p.array() + 0.5).floor().matrix();
      if (cell.cwiseAbs().maxCoeff() > 10) return 1.0;
      const auto part = [&](int axis) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis]) + 100);
      };
      Random random(seed * 1000003 + (part(0) * 1000 + part(1)) * 1000 + part(2));
      return random.between(-1, 1);
    };
    PolygonizerOptions options = within(12, 1);
    std::vector<Vec3> seeds;
    for (int i = 0; i < 24 * 24 * 24; ++i) seeds.emplace_back(i % 24 - 11.5, i / 24 % 24 - 11.5, i / 576 - 11.5);
    options.seed_reach = 0;
    const Polygonized surface = surface_of(noise, seeds, options);
    const MeshReport report = report_of(surface, true);
    CHECK(surface.complete());
    CHECK(report.closed);
    CHECK(report.oriented);
    CHECK(report.nonmanifold_edges == 0);
    CHECK(report.nonmanifold_vertices == 0);
    CHECK(report.faces > 10000);
  }
}

TEST_CASE("the same bytes for any number of threads and any order of seeds") {
  const auto torus = [](const Vec3& p) { return torus_at(p, 1, 0.4); };
  std::vector<Vec3> seeds = torus_points(300, 1, 0.4).positions;
  PolygonizerOptions options = within(2, 0.05);
  options.threads = 1;
  const Polygonized one = surface_of(torus, seeds, options);
  for (const int threads : {2, 8}) {
    options.threads = threads;
    std::reverse(seeds.begin(), seeds.end());
    const Polygonized other = surface_of(torus, seeds, options);
    CHECK(other.mesh.positions == one.mesh.positions);
    CHECK(other.mesh.corners == one.mesh.corners);
    CHECK(other.evaluations == one.evaluations);
  }
  options.threads = 2;
  const Polygonized single = surface_of(torus, {Vec3(1.4, 0, 0)}, options);
  CHECK(single.mesh.positions == one.mesh.positions);
  CHECK(single.mesh.corners == one.mesh.corners);
}

TEST_CASE("an endless surface ends at the box, the limit of cubes, or where the field does") {
  const auto plane = [](const Vec3& p) { return p.z() - 0.003; };
  const Polygonized boxed = surface_of(plane, {Vec3::Zero()}, within(1, 0.1));
  CHECK(boxed.reached_bounds);
  CHECK_FALSE(boxed.complete());
  CHECK(boxed.cells == 20 * 20);
  CHECK(boxed.mesh.face_count() == 2 * 20 * 20);
  PolygonizerOptions few = within(1000, 0.1);
  few.max_cells = 1000;
  const Polygonized limited = surface_of(plane, {Vec3::Zero()}, few);
  CHECK(limited.reached_max_cells);
  CHECK(limited.cells < 1500);
  CHECK(limited.mesh.face_count() > 0);
  const auto holey = [](const Vec3& p) {
    return p.x() > 0.5 ? std::numeric_limits<double>::quiet_NaN() : p.z() - 0.003;
  };
  const Polygonized ended = surface_of(holey, {Vec3::Zero()}, within(1, 0.1));
  CHECK(ended.reached_undefined);
  for (const Vec3& p : ended.mesh.positions) CHECK(p.x() <= 0.5);
}

TEST_CASE("where only a complete surface is wanted the search ends with the first sign that it isn't") {
  const auto plane = [](const Vec3& p) { return p.z() - 0.003; };
  const Vec3 near_side(0.75, 0, 0);
  PolygonizerOptions options = within(1, 0.1);
  options.only_complete = true;
  const Polygonized ended = surface_of(plane, {near_side}, options);
  CHECK(ended.reached_bounds);
  CHECK(ended.cells < 10 * 20);
  CHECK(ended.mesh.face_count() == 0);
  const auto ball = [](const Vec3& p) { return p.norm() - 0.7; };
  const Polygonized closed = surface_of(ball, {Vec3(0.7, 0, 0)}, options);
  options.only_complete = false;
  CHECK(closed.complete());
  CHECK(closed.mesh.positions == surface_of(ball, {Vec3(0.7, 0, 0)}, options).mesh.positions);
}

TEST_CASE("the search stops where the surface is covered already") {
  const auto sphere = [](const Vec3& p) { return p.norm() - 1; };
  PolygonizerOptions options = within(2, 0.05);
  options.covered = [](std::span<const Vec3> points, std::span<std::uint8_t> covered) {
    for (std::size_t i = 0; i < points.size(); ++i) covered[i] = points[i].z() < 0.7 ? 1 : 0;
  };
  const Polygonized cap = surface_of(sphere, {Vec3(0, 0, 1)}, options);
  CHECK(cap.complete());
  REQUIRE(cap.covered.size() == cap.mesh.positions.size());
  std::size_t covered = 0;
  for (std::size_t v = 0; v < cap.covered.size(); ++v) {
    CHECK((cap.covered[v] != 0) == (cap.mesh.positions[v].z() < 0.7));
    CHECK(cap.mesh.positions[v].z() > 0.7 - 3 * 0.05);
    covered += cap.covered[v];
  }
  CHECK(covered > 50);
  const MeshReport report = report_of(cap);
  CHECK(report.boundary_loops == 1);
  CHECK(report.euler_characteristic == 1);
}

TEST_CASE("seeds off the surface find it within their reach, others find nothing") {
  const auto sphere = [](const Vec3& p) { return p.norm() - 1; };
  PolygonizerOptions options = within(2, 0.1);
  for (const int reach : {0, 1, 4}) {
    options.seed_reach = reach;
    const bool found = surface_of(sphere, {Vec3(0.05, 0.05, 1 + 0.3)}, options).mesh.face_count() > 0;
    CHECK(found == (reach == 4));
  }
  options.seed_reach = 1;
  CHECK(surface_of(sphere, {}, options).mesh.vertex_count() == 0);
  CHECK(surface_of(sphere, {Vec3(NAN, 0, 0), Vec3(1e300, 0, 0), Vec3(-1e30, 5, 0)}, options).cells == 0);
}

TEST_CASE("far from the origin the surface is the same") {
  const Vec3 shift(1e6, 1e6, -1e6);
  const auto sphere = [&](const Vec3& p) { return (p - shift).norm() - 1e-2; };
  PolygonizerOptions options;
  options.cell = 1e-3;
  options.bounds = {shift - Vec3::Constant(0.02), shift + Vec3::Constant(0.02)};
  check_closed(surface_of(sphere, {shift + Vec3(0, 0, 1e-2)}, options), 2);
}

TEST_CASE("work and memory grow with the surface") {
  const auto sphere = [](const Vec3& p) { return p.norm() - 1; };
  const Polygonized coarse = surface_of(sphere, {Vec3(0, 0, 1)}, within(2, 0.04));
  const Polygonized fine = surface_of(sphere, {Vec3(0, 0, 1)}, within(2, 0.02));
  const double more = static_cast<double>(fine.cells) / static_cast<double>(coarse.cells);
  CHECK(more == Approx(4).epsilon(0.05));
  CHECK(static_cast<double>(fine.evaluations) / static_cast<double>(coarse.evaluations) < 1.05 * more);
  CHECK(fine.evaluations < 3 * fine.cells);
  CHECK(fine.bytes < 250 * fine.cells);  // the mesh included
}

TEST_CASE("the search can be cancelled, and bad options are refused") {
  const auto plane = [](const Vec3& p) { return p.z() - 0.003; };
  std::atomic<bool> cancel = false;
  int reports = 0;
  Progress stopping([&](double, const std::string&) { cancel = ++reports == 20; }, &cancel);
  PolygonizerOptions options = within(1000, 0.1);
  CHECK_THROWS_AS(polygonize(field_of(plane, 1e-6), std::vector{Vec3(0, 0, 0)}, options, stopping), Cancelled);
  for (const double cell : {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY), 1e-9})
    CHECK_THROWS_AS(surface_of(plane, {Vec3::Zero()}, within(1, cell)), Error);
  options = within(1, 0.1);
  options.bounds.low.x() = 3;
  CHECK_THROWS_AS(surface_of(plane, {Vec3::Zero()}, options), Error);
}

}  // namespace
}  // namespace croquis::implicit
