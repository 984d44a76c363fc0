// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

#include "attribute_surface/small_networks.h"
#include "croquis/attribute_surface/surface_cage.h"
#include "croquis/attribute_surface/surface_tessellation.h"
#include "croquis/geometry/mesh_report.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/meshes/surface_distance.h"

namespace croquis::test {
namespace {

struct CageOfNetwork {
  AttributeSurface surface;
  PolyMesh mesh;
};

CageOfNetwork cage_of(const AttributeNetwork& network, std::size_t segments) {
  Progress progress;
  CageOfNetwork made;
  made.surface = make_attribute_surface(network, progress);
  made.mesh = make_surface_cage(network, made.surface, {segments}, progress);
  return made;
}

MeshReport figures_of_cage(const PolyMesh& mesh) {
  Progress progress;
  return inspect(mesh, false, progress);
}

TEST_CASE("closed networks become closed cages of quads with their Euler number") {
  const std::vector<std::pair<AttributeNetwork, std::int64_t>> closed{
      {sphere_of_octants(), 2}, {cube_sphere(), 2}, {torus_of_quads(6, 4), 0}};
  for (const auto& [network, euler] : closed) {
    for (const std::size_t segments : {2U, 4U, 8U}) {
      INFO(network.name << ", " << segments << " segments");
      const PolyMesh mesh = cage_of(network, segments).mesh;
      const MeshReport report = figures_of_cage(mesh);
      CHECK(report.closed);
      CHECK(report.oriented);
      CHECK(report.nonmanifold_edges == 0);
      CHECK(report.euler_characteristic == euler);
      CHECK(mesh.corners.size() == 4 * mesh.face_count());
      CHECK(mesh.tags.empty());  // all curves are smooth
    }
  }
}

TEST_CASE("faces of any number of sides become as many quads as their sides ask for") {
  for (const std::size_t sides : {2U, 3U, 4U, 5U, 6U, 9U, 12U}) {
    for (const std::size_t segments : {2U, 4U, 8U}) {
      const AttributeNetwork network = sides == 2 ? small_leaf() : hill(sides, 0.4);
      const PolyMesh mesh = cage_of(network, segments).mesh;
      const std::size_t half = segments / 2;
      const std::size_t quads = sides == 2 ? half * half : sides == 4 ? segments * segments : sides * half * half;
      INFO(sides << " sides, " << segments << " segments");
      CHECK(mesh.face_count() == quads);
      const MeshReport report = figures_of_cage(mesh);
      CHECK(report.boundary_edges == sides * segments);
      CHECK(report.boundary_loops == 1);
      CHECK(report.euler_characteristic == 1);
      CHECK(report.degenerate_faces == 0);
    }
  }
}

TEST_CASE("cages lie on their surfaces, nodes where the network has them") {
  for (const AttributeNetwork& network : {cube_sphere(), sphere_of_octants(), torus_of_quads(6, 4)}) {
    const CageOfNetwork made = cage_of(network, 8);
    for (const AttributeNode& node : network.nodes) CHECK(std::ranges::count(made.mesh.positions, node.point) == 1);
    Progress progress;
    SurfaceTessellationOptions fine;
    fine.samples = 64;
    const SurfaceDistance distance(tessellate(network, made.surface, progress, fine).mesh);
    for (const Vec3& position : made.mesh.positions) CHECK(distance(position) < 0.002);
  }
}

TEST_CASE("curves in which faces meet at an angle are sharp, those of one face are not") {
  AttributeNetwork network = cube_sphere();
  for (AttributeCurve& curve : network.curves) curve.join = CurveJoin::Crease;
  const PolyMesh creased = cage_of(network, 4).mesh;
  CHECK(creased.tags.creases.size() == network.curves.size() * 4);
  CHECK(creased.tags.pins.empty());  // three creases meet at each node
  for (const Crease& crease : creased.tags.creases) CHECK(crease.sharpness == infinite_sharpness);

  network.faces.pop_back();
  const PolyMesh open = cage_of(network, 4).mesh;
  CHECK(open.tags.creases.size() == (network.curves.size() - 4) * 4);

  const PolyMesh leaf = cage_of(leaf_between_triangles(), 4).mesh;
  CHECK(leaf.tags.creases.size() == 8);  // the leaf's two arcs
  CHECK(leaf.tags.pins.size() == 2);     // which turn at its two nodes
}

}  // namespace
}  // namespace croquis::test
