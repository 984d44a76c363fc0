// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "croquis/io/json.h"
#include "croquis/operators/surface_result.h"
#include "operators/operations.h"
#include "perspective/network_shapes.h"
#include "support/check_operation.h"
#include "support/perspective/solids.h"

namespace croquis {
namespace {

AttributeNetwork shipped_network(const std::string& name) {
  const std::string path = CROQUIS_SOURCE_DIR "/examples/data/surface/" + name + ".json";
  return read_attribute_network(read_file(path), name).network;
}

Values network_input(const AttributeNetwork& network) {
  return {{"network", std::make_shared<const AttributeNetwork>(network)}};
}

Values with_questions(Values values, const std::string& places) {
  const std::string text = "{\"format\": \"croquis-abs-places/1\", \"places\": " + places + "}";
  values["evaluate"] = std::make_shared<const Report>(read_json(text, "places"));
  return values;
}

OperationResult surface_of(const Values& inputs, ParameterValues parameters = {}, Quality quality = Quality::Final) {
  Progress progress;
  Context context{progress, quality};
  return run(*surface_operation(), inputs, std::move(parameters), context);
}

Findings refused(const Values& inputs) {
  try {
    surface_of(inputs);
  } catch (const Error& error) {
    return error.findings();
  }
  FAIL("it was computed");
  return {};
}

}  // namespace

TEST_CASE("surfaces are functions of their network, their questions and their parameters") {
  const Values car = network_input(shipped_network("car_crashed"));
  test::check_operation(*surface_operation(), car, {});
  test::check_operation(*surface_operation(), with_questions(car, R"([{"face":"hood","fan":[1,0.25,0.5]}])"),
                        {{"tolerance", 0.02}, {"mode", std::string("position")}});
  test::check_operation(*surface_operation(), network_input(shipped_network("pocket5")),
                        {{"samples", std::int64_t{5}}, {"fullness", std::string("1.5")}});
  AttributeNetwork broken = shipped_network("tri_point");
  broken.faces[0].loop.pop_back();
  test::check_operation(*surface_operation(), network_input(broken), {});
}

TEST_CASE("drafts of surfaces have at most 16 samples") {
  const Values car = network_input(shipped_network("car_intact"));
  const auto faces = [&](std::int64_t samples, Quality quality) {
    return surface_of(car, {{"samples", samples}}, quality).outputs.at("mesh").get<PolyMesh>().face_count();
  };
  CHECK(faces(32, Quality::Draft) == faces(16, Quality::Final));
  CHECK(faces(4, Quality::Draft) == faces(4, Quality::Final));
}

TEST_CASE("windows find the surfaces, their parts of the mesh and what was measured") {
  const AttributeNetwork network = shipped_network("car_crashed");
  const OperationResult result = surface_of(network_input(network));
  const auto* found = result.details.get<SurfaceResult>();
  REQUIRE(found != nullptr);
  const auto& mesh = result.outputs.at("mesh").get<PolyMesh>();
  CHECK(found->parts.size() == 21);
  CHECK(found->parts.back().first_triangle + found->parts.back().triangle_count == mesh.face_count());
  CHECK(found->measures.point_errors.size() == 4);
  CHECK(byte_size(*found) > 12261 * (sizeof(Vec2) + sizeof(Index)));
  for (std::size_t f = 0; f < network.faces.size(); ++f) CHECK(found->surface->faces[f].surface != nullptr);
}

TEST_CASE("places of a surface that it doesn't have are named") {
  const Values inputs = with_questions(network_input(shipped_network("tri_point")),
                                       R"([{"face":"t","fan":[0,0.5,0.5]},{"face":"u","fan":[0,0,0]},
                                           {"face":"t","fan":[3,0,0]},{"face":"t","fan":[0,0.6,0.6]}])");
  const Findings findings = refused(inputs);
  REQUIRE(findings.size() == 3);
  CHECK(findings[0].code == "E_NO_FACE");
  CHECK(findings[1].code == "E_SYNTAX");
  CHECK(findings[2].code == "E_SYNTAX");
  CHECK(findings[2].message.find("places[3]") != std::string::npos);
  for (const Finding& finding : findings) CHECK(finding.category == Category::Malformed);
}

TEST_CASE("a network without faces has no surface") {
  const Findings findings = refused(network_input({}));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == "E_NO_FACES");
}

TEST_CASE("the network of a solid goes on to a surface that is as closed as the solid") {
  const Solid solid = test::solid_of(test::camera_body().network);
  const Values input{{"solid", std::make_shared<const Brep>(solid.brep)}};
  Progress progress;
  Context context{progress};
  const OperationResult network = run(*attribute_network_operation(), input, {}, context);
  const OperationResult surface = surface_of({{"network", network.outputs.at("network")}});
  const auto& faces = network.outputs.at("network").get<AttributeNetwork>().faces;
  CHECK(surface.details.get<SurfaceResult>()->parts.size() == faces.size());
}

}  // namespace croquis
