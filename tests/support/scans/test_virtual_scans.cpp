// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
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

TEST_CASE("ragged cuts leave one simple rim each, and what is missing is known") {
  const PolyMesh complete = sculpt(Sculpture::Beast, 10000);
  const CutScan scan = ragged_cuts(complete, {});
  CHECK(scan.removed.size() == 12);
  CHECK(MeshTopology(scan.mesh).boundary_loops().size() == scan.removed.size());
  CHECK(scan.mesh.face_count() + removed_count(scan) == complete.face_count());
  CHECK(ragged_cuts(complete, {}).removed == scan.removed);
}

TEST_CASE("distances to appended faces don't see those before") {
  PolyMesh two = merged(round_sphere(2), translated(round_sphere(2), {5, 0, 0}));
  const SurfaceDistance second(two, two.face_count() / 2);
  CHECK(second(Vec3(0, 0, 0)) == Approx(4).epsilon(0.01));
}
