// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/attribute_surface/attribute_surface.h"
#include "croquis/attribute_surface/surface_tessellation.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/triangle_tree.h"
#include "croquis/perspective/solid.h"
#include "operators/operations.h"
#include "perspective/network_shapes.h"
#include "support/check_operation.h"
#include "support/perspective/solids.h"

/// From a solid to cages and networks.
namespace croquis {
namespace {

Values solid_input(const Solid& solid) { return {{"solid", std::make_shared<const Brep>(solid.brep)}}; }

PolyMesh subdivided_cage(const Solid& solid, const std::string& segments, const std::string& scheme) {
  Progress progress;
  Context context{progress};
  const OperationResult cage = run(*patch_cage_operation(), solid_input(solid), {{"segments", segments}}, context);
  CHECK(cage.warnings.empty());
  const ParameterValues parameters{{"scheme", scheme}, {"levels", std::int64_t{2}}};
  OperationResult result = run(*subdivide_operation(), {{"cage", cage.outputs.at("cage")}}, parameters, context);
  for (const Finding& warning : result.warnings) FAIL_CHECK(warning.message);
  return result.outputs.at("mesh").get<PolyMesh>();
}

TriangleTree tree_of(const PolyMesh& mesh) {
  std::vector<std::array<Vec3, 3>> triangles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      triangles.push_back({mesh.positions[face[0]], mesh.positions[face[i]], mesh.positions[face[i + 1]]});
  }
  return TriangleTree(std::move(triangles));
}

/// The greatest distance of the vertices of one from the other.
double distance_from(const PolyMesh& mesh, const PolyMesh& other) {
  const TriangleTree tree = tree_of(other);
  double greatest = 0;
  for (const Vec3& position : mesh.positions) greatest = std::max(greatest, tree.nearest(position, 1e300).distance);
  return greatest;
}

double diagonal(const PolyMesh& mesh) {
  const auto box = *bounds_of(mesh);
  return (box[1] - box[0]).norm();
}

TEST_CASE("solids become networks and cages as functions of their arguments") {
  const Solid bottle = test::solid_of(test::bottle().network), camera = test::solid_of(test::camera_body().network);
  for (const Solid* solid : {&bottle, &camera}) {
    test::check_operation(*patch_cage_operation(), solid_input(*solid), {{"segments", std::string("8")}});
    test::check_operation(*attribute_network_operation(), solid_input(*solid), {});
  }
}

TEST_CASE("subdivided cages of solids are closed and don't intersect themselves") {
  for (const test::PerspectiveSolid& shape : test::all_solids()) {
    const Solid solid = test::solid_of(shape.network);
    for (const char* scheme : {"doo-sabin", "catmull-clark"}) {
      INFO(shape.name << ", " << scheme);
      const PolyMesh mesh = subdivided_cage(solid, "4", scheme);
      Progress progress;
      const MeshReport report = inspect(mesh, true, progress);
      CHECK(report.closed);
      CHECK(report.euler_characteristic == 2 * (shape.shells - shape.genus));
      CHECK(report.self_intersections == 0);
    }
  }
}

TEST_CASE("the subdivided bottle comes nearer to its patches with every doubling of segments") {
  const Solid bottle = test::solid_of(test::bottle().network);
  const PolyMesh& exact = bottle.tessellation.mesh;
  for (const char* scheme : {"doo-sabin", "catmull-clark"}) {
    double before = 0.01;
    for (const char* segments : {"4", "8", "16"}) {
      const PolyMesh mesh = subdivided_cage(bottle, segments, scheme);
      const double distance = std::max(distance_from(mesh, exact), distance_from(exact, mesh)) / diagonal(exact);
      INFO(scheme << ", " << segments << " segments: " << distance << " of the diagonal");
      CHECK(distance < before);
      before = distance / 2;
    }
  }
}

TEST_CASE("networks of solids are attribute surfaces: a patch for every face of 2 to 12 curves") {
  for (const test::PerspectiveSolid& shape : test::all_solids()) {
    INFO(shape.name);
    const Solid solid = test::solid_of(shape.network);
    Progress progress;
    Context context{progress};
    const OperationResult made = run(*attribute_network_operation(), solid_input(solid), {}, context);
    const AttributeNetwork& network = made.outputs.at("network").get<AttributeNetwork>();
    CHECK(network.faces.size() + made.warnings.size() == solid.brep.faces.size());  // the others are named
    if (network.faces.empty()) continue;
    const AttributeSurface surface = make_attribute_surface(network, progress);
    for (std::size_t f = 0; f < network.faces.size(); ++f) {
      INFO(network.faces[f].id);
      CHECK(surface.faces[f].surface != nullptr);
    }
    CHECK(!has_errors(surface.findings));
    for (std::size_t c = 0; c < network.curves.size(); ++c) {
      const bool joined = network.curves[c].join == CurveJoin::Smooth && surface.curves[c].faces.size() == 2;
      CHECK(surface.curves[c].smooth == joined);
    }
    const MeshReport report = inspect(tessellate(network, surface, progress).mesh, false, progress);
    CHECK(report.oriented);
    CHECK(report.nonmanifold_edges == 0);
    if (made.warnings.empty()) {
      CHECK(report.closed);
      CHECK(report.euler_characteristic == 2 * (shape.shells - shape.genus));
    }
  }
}

}  // namespace
}  // namespace croquis
