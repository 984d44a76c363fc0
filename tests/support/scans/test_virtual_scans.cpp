// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
#include "support/random.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;

namespace {

std::ptrdiff_t euler_characteristic(const PolyMesh& mesh, const MeshTopology& topology) {
  return static_cast<std::ptrdiff_t>(mesh.vertex_count() + mesh.face_count()) -
         static_cast<std::ptrdiff_t>(topology.edge_count());
}

std::size_t removed_count(const CutScan& scan) {
  std::size_t count = 0;
  for (const auto& faces : scan.removed) count += faces.size();
  return count;
}

/// Least distance to a dense cloud of samples: never below the distance to the triangles.
double cloud_distance(const std::vector<Vec3>& cloud, const Vec3& point) {
  double least = 1e9;
  for (const Vec3& p : cloud) least = std::min(least, (p - point).norm());
  return least;
}

}  // namespace

TEST_CASE("sculptures are closed, of one piece, of the genus told and of the size wanted") {
  for (const Sculpture sculpture : all_sculptures) {
    CAPTURE(name_of(sculpture));
    const PolyMesh mesh = sculpt(sculpture, 10000);
    const MeshTopology topology(mesh);
    CHECK(std::abs(static_cast<double>(mesh.face_count()) / 10000 - 1) < 0.1);
    CHECK(topology.boundary_loops().size() == 0);
    const bool has_handle =
        sculpture == Sculpture::Mug || sculpture == Sculpture::Knot || sculpture == Sculpture::Housing;
    const std::ptrdiff_t handles = sculpture == Sculpture::Bracket ? 5 : has_handle ? 1 : 0;
    CHECK(euler_characteristic(mesh, topology) == 2 - 2 * handles);
    CHECK(sculpt(sculpture, 10000).positions == mesh.positions);
  }
}

TEST_CASE("solids come out in triangles finer than the steps in which they are looked for") {
  const PolyMesh mesh = sculpt([](const Vec3& p) { return p.norm() - 0.309; }, 150000);
  CHECK(static_cast<double>(mesh.face_count()) == Approx(150000).epsilon(0.2));
  CHECK(MeshTopology(mesh).boundary_loops().size() == 0);
}

TEST_CASE("sharp edges of machined pieces run along edges of the mesh") {
  for (const Sculpture sculpture : {Sculpture::Bracket, Sculpture::Housing}) {
    const PolyMesh mesh = sculpt(sculpture, 20000);
    std::vector<double> errors;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto t = mesh.face(f);
      const Vec3 middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
      errors.push_back(std::abs(field_value(sculpture, middle)));
    }
    std::sort(errors.begin(), errors.end());
    CHECK(errors[errors.size() * 98 / 100] < 1e-3 * diagonal_of(mesh));  // a cut corner is wrong by 3e-3 of it
  }
}

TEST_CASE("ragged cuts leave one simple rim each, and what is missing is known") {
  const PolyMesh complete = sculpt(Sculpture::Beast, 10000);
  const CutScan scan = ragged_cuts(complete, {});
  CHECK(scan.removed.size() == 12);
  CHECK(MeshTopology(scan.mesh).boundary_loops().size() == scan.removed.size());
  CHECK(scan.mesh.face_count() + removed_count(scan) == complete.face_count());
  CHECK(ragged_cuts(complete, {}).removed == scan.removed);
}

TEST_CASE("a ragged ring leaves an island") {
  RaggedCuts cuts;
  cuts.count = 2, cuts.low = 0.08, cuts.high = 0.1, cuts.island = 0.4;
  const CutScan scan = ragged_cuts(sculpt(Sculpture::Armour, 10000), cuts);
  REQUIRE(scan.removed.size() == 2);
  CHECK(MeshTopology(scan.mesh).boundary_loops().size() == 4);
}

TEST_CASE("a scanner sees the near half of a sphere, and a grid of depths lies upon it") {
  const PolyMesh ball = round_sphere(5);
  const Vec3 up(0, 0, 1);
  const CutScan seen = seen_from(ball, std::span(&up, 1));
  const SurfaceDistance surface(ball);
  for (const Index v : seen.mesh.corners) CHECK(seen.mesh.positions[v].z() > 0.2);
  CHECK(static_cast<double>(seen.mesh.face_count()) > 0.3 * static_cast<double>(ball.face_count()));
  const PolyMesh sheet = range_images(ball, std::span(&up, 1), 0.05);
  REQUIRE(sheet.face_count() > 1000);
  for (const Vec3& p : sheet.positions) {
    CHECK(surface(p) < 1e-12);
    CHECK(p.z() > -1e-9);
  }
}

TEST_CASE("noise has the deviation asked for and moves along normals") {
  const PolyMesh ball = round_sphere(5);
  const PolyMesh noisy = with_noise(ball, 1, 0.1);
  double squares = 0;
  for (std::size_t v = 0; v < ball.vertex_count(); ++v) {
    const Vec3 move = noisy.positions[v] - ball.positions[v];
    CHECK((move - move.dot(ball.positions[v]) * ball.positions[v]).norm() < 0.02 * move.norm() + 1e-12);
    squares += move.squaredNorm();
  }
  const double edge = (ball.positions[ball.face(0)[0]] - ball.positions[ball.face(0)[1]]).norm();
  CHECK(std::sqrt(squares / static_cast<double>(ball.vertex_count())) == Approx(0.1 * edge).epsilon(0.2));
}

TEST_CASE("distances to a surface are those to all its triangles") {
  const PolyMesh soup = random_soup(3, 200);
  std::vector<Index> faces;
  for (Index f = 0; f < soup.face_count(); ++f) faces.push_back(f);
  const std::vector<Vec3> cloud = sample_faces(soup, faces, 40000);
  CHECK(std::abs(static_cast<double>(cloud.size()) - 40000) <= 1);
  const SurfaceDistance distance(soup);
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p(random.between(-0.5, 1.5), random.between(-0.5, 1.5), random.between(-0.5, 1.5));
    double least = 1e9;
    for (const Index f : faces) least = std::min(least, SurfaceDistance(soup, std::span(&f, 1))(p));
    CHECK(distance(p) == least);
    CHECK(least <= cloud_distance(cloud, p));
    CHECK(least > cloud_distance(cloud, p) - 0.1);
  }
  CHECK(summary_of_distances(cloud, distance).greatest < 1e-12);
}

TEST_CASE("distances to appended faces don't see those before") {
  PolyMesh two = merged(round_sphere(2), translated(round_sphere(2), {5, 0, 0}));
  const SurfaceDistance second(two, two.face_count() / 2);
  CHECK(second(Vec3(0, 0, 0)) == Approx(4).epsilon(0.01));
}
