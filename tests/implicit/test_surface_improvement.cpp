// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/implicit/marching_cubes.h"
#include "croquis/implicit/surface_improvement.h"
#include "implicit/sample_fields.h"
#include "implicit/sample_points.h"
#include "support/difference_field.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/surface_smoothing.h"

namespace croquis::implicit {
namespace {

using namespace croquis::test;

constexpr double h = 0.1;

Field sphere_field() {
  return field_of([](const Vec3& p) { return sphere_at(p, Vec3::Zero(), 1); }, 1e-6);
}

ProjectionOptions steps_of(double cell) {
  ProjectionOptions options;
  options.cell = cell;
  return options;
}

PolyMesh cubes_of(const Field& field, const Vec3& seed) {
  PolygonizerOptions options;
  options.cell = h;
  options.bounds = {Vec3::Constant(-2), Vec3::Constant(2)};
  Progress progress;
  return polygonize(field, std::vector{seed}, options, progress).mesh;
}

double volume(const PolyMesh& mesh) {
  Progress progress;
  return *inspect(mesh, false, progress).volume;
}

/// Smallest angle of every triangle, in degrees, ascending.
std::vector<double> smallest_angles(const PolyMesh& mesh) {
  std::vector<double> angles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    double least = 180;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& at = mesh.positions[mesh.face(f)[k]];
      const Vec3 a = mesh.positions[mesh.face(f)[(k + 1) % 3]] - at;
      const Vec3 b = mesh.positions[mesh.face(f)[(k + 2) % 3]] - at;
      least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI);
    }
    angles.push_back(least);
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

TEST_CASE("projection brings points onto the surface and leaves fixed ones alone") {
  std::vector<Vec3> points = sphere_points(1000, Vec3::Zero(), 1).positions;
  for (std::size_t i = 0; i < points.size(); ++i) points[i] *= 1 + 0.15 * std::sin(static_cast<double>(i));
  const std::vector<Vec3> before = points;
  std::vector<std::uint8_t> fixed(points.size(), 0);
  for (std::size_t i = 0; i < fixed.size(); i += 5) fixed[i] = 1;
  const ProjectionReport report = project(points, fixed, sphere_field(), steps_of(h));
  CHECK(report.moved == 800);
  CHECK(report.not_converged == 0);
  CHECK(report.largest_move == Approx(0.15).margin(0.01));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (fixed[i] != 0) {
      CHECK(points[i] == before[i]);
    } else {
      CHECK(std::abs(points[i].norm() - 1) < 1e-6 * h);
      CHECK((points[i] - before[i].normalized()).norm() < 1e-6);
    }
  }
}

TEST_CASE("projection takes bounded steps where the field is flat, and names what it can't bring there") {
  const auto flat = [](const Vec3& p) { return 1e-3 * p.x() + 5; };
  std::vector<Vec3> points = {Vec3::Zero()};
  ProjectionReport report = project(points, {}, field_of(flat, 1e-6), steps_of(h));
  CHECK(report.not_converged == 1);
  CHECK(points[0].norm() <= 20 * 0.5 * h + 1e-12);
  const auto nowhere = [](const Vec3&) { return std::numeric_limits<double>::quiet_NaN(); };
  points = {Vec3(1, 2, 3)};
  report = project(points, {}, field_of(nowhere, 1e-6), steps_of(h));
  CHECK(report.not_converged == 1);
  CHECK(points[0] == Vec3(1, 2, 3));
}

TEST_CASE("smoothed with projection a sphere keeps its volume and gets even triangles") {
  const PolyMesh cubes = cubes_of(sphere_field(), Vec3(1, 0, 0));
  PolyMesh smooth = cubes;
  const ProjectionReport report = smooth_on_surface(smooth, sphere_field(), 5, steps_of(h));
  CHECK(report.not_converged == 0);
  CHECK(volume(smooth) > 0.999 * volume(cubes));
  for (const Vec3& p : smooth.positions) CHECK(std::abs(p.norm() - 1) < 1e-6 * h);
  const auto before = smallest_angles(cubes);
  const auto after = smallest_angles(smooth);
  CHECK(after.front() > 10);
  CHECK(after.front() > 5 * before.front());
  CHECK(after[after.size() / 2] > 40);
  CHECK(smooth.corners == cubes.corners);
}

TEST_CASE("splitting makes four triangles of each and keeps shape, orientation and Euler number") {
  for (const PolyMesh& mesh : {triangulated(cube()), triangulated(torus(12, 8)), triangulated(grid(4, 3)),
                               triangulated(moebius(6)), tetrahedra_sharing_edge()}) {
    Progress progress;
    const MeshReport coarse = inspect(mesh, false, progress);
    const PolyMesh fine = split_in_four(mesh);
    const MeshReport report = inspect(fine, false, progress);
    CHECK(report.faces == 4 * coarse.faces);
    CHECK(report.vertices == coarse.vertices + coarse.edges);
    CHECK(report.boundary_edges == 2 * coarse.boundary_edges);
    CHECK(report.euler_characteristic == coarse.euler_characteristic);
    CHECK(report.oriented == coarse.oriented);
    CHECK(report.area == Approx(coarse.area));
    if (coarse.volume) CHECK(*report.volume == Approx(*coarse.volume));
    CHECK(std::equal(mesh.positions.begin(), mesh.positions.end(), fine.positions.begin()));
  }
}

TEST_CASE("split and projected, a sphere comes nearer with the square of the edge") {
  PolyMesh mesh = cubes_of(sphere_field(), Vec3(1, 0, 0));
  project(mesh.positions, {}, sphere_field(), steps_of(h));
  double last = 4 * M_PI / 3 - volume(mesh);
  for (int level = 0; level < 2; ++level) {
    mesh = split_in_four(mesh);
    project(mesh.positions, {}, sphere_field(), steps_of(h));
    const double error = 4 * M_PI / 3 - volume(mesh);
    CHECK(last / error == Approx(4).epsilon(0.1));
    last = error;
  }
}

TEST_CASE("projection gives the same bits for any number of threads") {
  std::vector<std::vector<Vec3>> all;
  for (const int threads : {1, 2, 8}) {
    std::vector<Vec3> points = torus_points(2000, 1, 0.45).positions;
    ProjectionOptions options = steps_of(h);
    options.threads = threads;
    project(points, {}, field_of([](const Vec3& p) { return torus_at(p, 1, 0.4); }, 1e-6), options);
    all.push_back(points);
  }
  CHECK(all[0] == all[1]);
  CHECK(all[0] == all[2]);
}

TEST_CASE("meshes of other polygons and marks of another size are refused") {
  PolyMesh quads = cube();
  CHECK_THROWS_AS(split_in_four(quads), Error);
  PolyMesh mesh = triangulated(cube());
  const std::vector<std::uint8_t> few(3, 0);
  CHECK_THROWS_AS(project(mesh.positions, few, sphere_field(), steps_of(h)), Error);
  CHECK_THROWS_AS(project(mesh.positions, {}, sphere_field(), steps_of(0)), Error);
}

}  // namespace
}  // namespace croquis::implicit
