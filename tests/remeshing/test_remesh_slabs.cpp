// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "hole_filling/fill_invariants.h"
#include "remeshing/remeshed.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;
using namespace croquis::remeshing;

namespace {

RemeshResult remesh(const PolyMesh& mesh, RemeshOptions options, std::size_t slab_points, int threads = 2) {
  options.slab_points = slab_points;
  options.fill.threads = threads;
  return test::remesh(mesh, options);
}

void check_same(const RemeshResult& a, const RemeshResult& b) {
  CHECK(a.mesh.positions == b.mesh.positions);
  CHECK(a.mesh.corners == b.mesh.corners);
  REQUIRE(a.mesh.channels.size() == b.mesh.channels.size());
  for (std::size_t c = 0; c < a.mesh.channels.size(); ++c) CHECK(a.mesh.channels[c].data == b.mesh.channels[c].data);
  CHECK(a.domains == b.domains);
  CHECK(a.points_per_domain.median == b.points_per_domain.median);
}

/// One slab, two, seven, and one per layer of cubes.
void check_any_slabs(const PolyMesh& mesh, const RemeshOptions& options = {}) {
  const std::size_t count = mesh.vertex_count();
  const RemeshResult whole = remesh(mesh, options, 10 * count);
  CHECK(whole.slabs == 1);
  std::size_t slabs = 1;
  for (const std::size_t points : {count / 2, count / 7, std::size_t{1}}) {
    CAPTURE(points);
    const RemeshResult result = remesh(mesh, options, points);
    CHECK(result.slabs >= slabs);
    slabs = result.slabs;
    check_same(whole, result);
  }
  CHECK(slabs > 3);
}

PolyMesh holed_torus(double turn) {
  return random_cuts(rotated(ring_torus(160, 80), turn, Vec3(1, 2, 0).normalized()), 1, 6, 0.05, 0.2).mesh;
}

}  // namespace

TEST_CASE("in one slab or many, along any axis, the same model is made bit by bit") {
  for (const double turn : {0.0, 1.2}) check_any_slabs(holed_torus(turn));
  for (const int axis : {0, 1, 2}) {
    CAPTURE(axis);
    Vec3 size(1, 1, 1);
    size[axis] = 3;
    check_any_slabs(transformed(round_sphere(5), Eigen::Affine3d(Eigen::Scaling(size))));
  }
}

TEST_CASE("slabs and threads together change nothing") {
  const PolyMesh mesh = holed_torus(0.3);
  const RemeshResult one = remesh(mesh, {}, 1'000'000, 1);
  for (const std::size_t points : {std::size_t{1'000'000}, mesh.vertex_count() / 2, mesh.vertex_count() / 7}) {
    for (const int threads : {1, 2, 8}) {
      CAPTURE(points, threads);
      check_same(one, remesh(mesh, {}, points, threads));
    }
  }
}

TEST_CASE("slabs change nothing of open, refined, snapped and rounded models, nor of several pieces") {
  check_any_slabs(open_tube(1, 6, 80, 160));
  check_any_slabs(merged(bowl(96, 40), translated(round_sphere(4), Vec3(3, 0, 0))));
  check_any_slabs(merged(round_sphere(4), translated(round_sphere(4), Vec3(1.5, 0, 0))));
  RemeshOptions options;
  options.refine = 1;
  options.snap = 0.3;
  options.smoothing = 5;
  options.fill.precision = Precision::Single;
  check_any_slabs(holed_torus(0.5), options);
  options.smoothing = 0;
  check_any_slabs(holed_torus(0.5), options);
}

TEST_CASE("with every preset slabs change nothing") {
  const PolyMesh mesh = random_cuts(ring_torus(100, 50), 2, 4, 0.05, 0.2).mesh;
  for (const Preset preset : {Preset::Paper, Preset::Sharp, Preset::Noisy}) {
    CAPTURE(static_cast<int>(preset));
    check_any_slabs(mesh, remesh_preset(preset));
  }
}
