// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/mesh_topology.h"
#include "operators/operations.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/check_operation.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

/// From drawings and meshes to attribute networks.
namespace croquis {
namespace {

Values mesh_input(PolyMesh mesh) { return {{"mesh", std::make_shared<const PolyMesh>(std::move(mesh))}}; }

AttributeNetwork network_of(const Operation& operation, const Values& inputs, const ParameterValues& parameters) {
  Progress progress;
  Context context{progress};
  return run(operation, inputs, parameters, context).outputs.at("network").get<AttributeNetwork>();
}

std::string refusal_of(const ParameterValues& parameters) {
  try {
    network_of(*edge_network_operation(), mesh_input(test::cube()), parameters);
  } catch (const Error& error) {
    return error.findings().at(0).code;
  }
  return "";
}

TEST_CASE("drawings and meshes become networks as functions of their arguments") {
  Drawing drawing;
  for (const double y : {0.0, 3.0}) {
    Stroke stroke;
    stroke.id = "s" + std::to_string(drawing.strokes.size());
    for (int i = 0; i <= 40; ++i) stroke.samples.push_back({Vec2(i, y + i * i / 100.0)});
    drawing.strokes.push_back(stroke);
  }
  test::check_operation(*contour_network_operation(), {{"drawing", std::make_shared<const Drawing>(drawing)}},
                        {{"corner", 50.0}});
  test::check_operation(*edge_network_operation(), mesh_input(test::grid(5, 3)), {{"slopes", true}});
  test::check_operation(*edge_network_operation(), mesh_input(test::bolt()), {{"select", std::string("sharp")}});
}

TEST_CASE("edges are chosen by name, as boundaries or by the angle of their faces") {
  const auto curves = [](PolyMesh mesh, const ParameterValues& parameters) {
    return network_of(*edge_network_operation(), mesh_input(std::move(mesh)), parameters).curves.size();
  };
  CHECK(curves(test::cube(), {{"select", std::string("sharp")}}) == 12);
  CHECK(curves(test::grid(5, 3), {}) == 4);
  CHECK(curves(test::grid(5, 3), {{"edges", std::string("0-1,1-2; 8-2")}}) == 2);
  CHECK(curves(test::icosahedron(), {{"select", std::string("sharp")}, {"angle", 30.0}}) == 30);
  CHECK(refusal_of({{"select", std::string("sharp")}, {"angle", 91.0}}) == "E_NO_EDGES");
  CHECK(refusal_of({}) == "E_NO_EDGES");
  CHECK(refusal_of({{"edges", std::string("0-6")}}) == "E_PARAMETER");
  CHECK(refusal_of({{"edges", std::string("0-1-2")}}) == "E_PARAMETER");
  CHECK(refusal_of({{"edges", std::string("nose")}}) == "E_PARAMETER");
  CHECK(refusal_of({{"edges", std::string("0-99")}}) == "E_PARAMETER");
}

Values network_input(AttributeNetwork network) {
  return {{"network", std::make_shared<const AttributeNetwork>(std::move(network))}};
}

PolyMesh holed_sphere() {
  return test::without_faces(test::uv_sphere(24, 12), std::vector<Index>{0, 1, 2, 3, 4, 5, 130, 131, 154, 155});
}

OperationResult result_of(const Operation& operation, const Values& inputs, const ParameterValues& parameters) {
  Progress progress;
  Context context{progress};
  return run(operation, inputs, parameters, context);
}

TEST_CASE("patches and cages are functions of their arguments") {
  test::check_operation(*surface_patch_operation(), mesh_input(holed_sphere()), {});
  test::check_operation(*surface_patch_operation(), mesh_input(holed_sphere()),
                        {{"join", std::string("crease")}, {"sides", std::int64_t{5}}});
  test::check_operation(*surface_cage_operation(), network_input(test::cube_sphere()),
                        {{"segments", std::string("8")}});
}

TEST_CASE("holes to patch are chosen by number or by a vertex of their rim") {
  const PolyMesh sphere = holed_sphere();
  const auto boundary_loops = [&](const ParameterValues& parameters) {
    const OperationResult result = result_of(*surface_patch_operation(), mesh_input(sphere), parameters);
    CHECK(result.warnings.empty());
    Progress progress;
    return inspect(result.outputs.at("mesh").get<PolyMesh>(), false, progress).boundary_loops;
  };
  Progress progress;
  REQUIRE(inspect(sphere, false, progress).boundary_loops == 2);
  CHECK(boundary_loops({}) == 0);
  CHECK(boundary_loops({{"only", std::string("1")}}) == 1);
  CHECK(boundary_loops({{"only", std::string("0-1")}}) == 0);
  const MeshTopology topology(sphere);
  const std::int64_t rim_vertex = topology.boundary_loops()[0][1];
  CHECK(boundary_loops({{"vertex", rim_vertex}}) == 1);
  for (const ParameterValues& wrong :
       {ParameterValues{{"only", std::string("7")}}, ParameterValues{{"vertex", std::int64_t{99999}}},
        ParameterValues{{"sides", std::int64_t{2}}}, ParameterValues{{"fullness", std::string("2.1")}},
        ParameterValues{{"fullness", std::string("-1.1")}}, ParameterValues{{"fullness", std::string("full")}}})
    CHECK_THROWS_AS(result_of(*surface_patch_operation(), mesh_input(sphere), wrong), Error);
  for (const char* fullness : {"-1", "0.5", "2", "auto"})
    CHECK(boundary_loops({{"fullness", std::string(fullness)}}) == 0);
}

TEST_CASE("subdivided cages of closed networks come near to the surface, the more segments the nearer") {
  double before = 0.2;
  for (const char* segments : {"2", "4", "8"}) {
    const OperationResult cage = result_of(*surface_cage_operation(), network_input(test::sphere_of_octants()),
                                           {{"segments", std::string(segments)}});
    const OperationResult smooth =
        result_of(*subdivide_operation(), {{"cage", cage.outputs.at("cage")}}, {{"levels", std::int64_t{2}}});
    const PolyMesh& mesh = smooth.outputs.at("mesh").get<PolyMesh>();
    double farthest = 0;
    for (const Vec3& position : mesh.positions) farthest = std::max(farthest, std::abs(position.norm() - 1));
    INFO(segments << " segments: " << farthest);
    CHECK(farthest < before);
    before = std::max(0.6 * farthest, 0.02);  // what the octants themselves are off a sphere
    Progress progress;
    CHECK(inspect(mesh, true, progress).self_intersections == 0);
  }
}

}  // namespace
}  // namespace croquis
