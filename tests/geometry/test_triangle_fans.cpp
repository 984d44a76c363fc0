// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/triangle_fans.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;

using Link = TriangleFans::Link;

TEST_CASE("links agree with the topology of the mesh, on any soup") {
  std::vector<PolyMesh> meshes = {round_sphere(2), sheet(5, 4), triangulated(tetrahedra_sharing_edge()),
                                  triangulated(tetrahedra_sharing_vertex()), flipped_face(round_sphere(1), 3)};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    PolyMesh mesh = sheet(6, 6);
    Random random(seed);
    std::vector<Index> removed;
    for (Index f = 0; f < mesh.face_count(); ++f)
      if (random.unit() < 0.3) removed.push_back(f);
    meshes.push_back(without_faces(mesh, removed));
  }
  for (const PolyMesh& mesh : meshes) {
    const TriangleFans fans(mesh.vertex_count(), mesh.corners);
    const MeshTopology topology(mesh);
    Progress progress;
    const MeshReport report = inspect(mesh, false, progress);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      CHECK(fans.at(v).size() == topology.vertex_corners(v).size());
      CHECK((fans.link(v) == Link::None) == topology.vertex_corners(v).empty());
      if (report.oriented && fans.link(v) != Link::None)
        CHECK((fans.link(v) != Link::Broken) == topology.is_manifold(v));
    }
    if (report.oriented && report.nonmanifold_vertices == 0)
      CHECK(open_loop_count(fans, fans.links(1, progress)) == report.boundary_loops);
  }
}

TEST_CASE("faces that disagree break the links of their vertices") {
  const PolyMesh mesh = flipped_face(round_sphere(1), 3);
  const TriangleFans fans(mesh.vertex_count(), mesh.corners);
  for (const Index v : mesh.face(3)) CHECK(fans.link(v) == Link::Broken);
}
