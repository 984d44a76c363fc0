// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "operators/surface/contour_network_operation.h"
#include "operators/surface/edge_network_operation.h"
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
    network_of(EdgeNetworkOperation(), mesh_input(test::cube()), parameters);
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
  test::check_operation(ContourNetworkOperation(), {{"drawing", std::make_shared<const Drawing>(drawing)}},
                        {{"corner", 50.0}});
  test::check_operation(EdgeNetworkOperation(), mesh_input(test::grid(5, 3)), {{"slopes", true}});
  test::check_operation(EdgeNetworkOperation(), mesh_input(test::bolt()), {{"select", std::string("sharp")}});
}

TEST_CASE("edges are chosen by name, as boundaries or by the angle of their faces") {
  const auto curves = [](PolyMesh mesh, const ParameterValues& parameters) {
    return network_of(EdgeNetworkOperation(), mesh_input(std::move(mesh)), parameters).curves.size();
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

}  // namespace
}  // namespace croquis
