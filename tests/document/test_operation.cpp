// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/operation.h"
#include "croquis/document/registry.h"

namespace croquis {
namespace {

/// Scales a mesh; counts how often it was asked.
Operation scale(int& calls, std::string id = "scale") {
  return {{std::move(id),
           1,
           "Scale",
           "Makes a mesh larger or smaller.",
           {{"mesh", ValueType::Mesh, "The mesh."}},
           {{"mesh", ValueType::Mesh, "The scaled mesh."}},
           {{"factor", ParameterType::Number, 2.0, 0.1, 10.0, {}, "", "How much larger."}}},
          [&calls](const Values& inputs, const ParameterValues& parameters, Context&) -> OperationResult {
            ++calls;
            PolyMesh mesh = inputs.at("mesh").get<PolyMesh>();
            for (Vec3& position : mesh.positions) position *= std::get<double>(parameters.at("factor"));
            return {{{"mesh", std::make_shared<const PolyMesh>(std::move(mesh))}}, {}};
          }};
}

Value point_mesh() {
  PolyMesh mesh;
  mesh.positions = {Vec3(1, 2, 3)};
  return std::make_shared<const PolyMesh>(std::move(mesh));
}

Vec3 scaled_point(const OperationResult& result) { return result.outputs.at("mesh").as<PolyMesh>()->positions.front(); }

TEST_CASE("an operation runs with the defaults of its description") {
  int calls = 0;
  Progress progress;
  Context context{progress};
  CHECK(scaled_point(run(scale(calls), {{"mesh", point_mesh()}}, {}, context)) == Vec3(2, 4, 6));
  CHECK(scaled_point(run(scale(calls), {{"mesh", point_mesh()}}, {{"factor", 3.0}}, context)) == Vec3(3, 6, 9));
  CHECK(calls == 2);
}

TEST_CASE("an operation is not asked when an input or a parameter is wrong") {
  int calls = 0;
  Progress progress;
  Context context{progress};
  const auto code_of = [&](const Values& inputs, ParameterValues parameters) {
    try {
      run(scale(calls), inputs, std::move(parameters), context);
    } catch (const Error& error) {
      return error.findings().front().code + " " + error.findings().front().subjects.front().id;
    }
    return std::string("no error");
  };
  CHECK(code_of({}, {}) == "E_INPUT mesh");
  CHECK(code_of({{"mesh", std::make_shared<const Report>()}}, {}) == "E_INPUT mesh");
  CHECK(code_of({{"mesh", point_mesh()}}, {{"factor", 11.0}}) == "E_PARAMETER factor");
  CHECK(code_of({{"mesh", point_mesh()}}, {{"size", 1.0}}) == "E_PARAMETER size");
  CHECK(calls == 0);
}

TEST_CASE("the registry finds operations by id and refuses a second one of the same id") {
  int calls = 0;
  Registry registry;
  registry.add(std::make_unique<Operation>(scale(calls)));
  registry.add(std::make_unique<Operation>(scale(calls, "enlarge")));
  CHECK(registry.find("scale") == registry.operations()[0].get());
  CHECK(registry.find("enlarge") == registry.operations()[1].get());
  CHECK(registry.find("twist") == nullptr);
  CHECK_THROWS_AS(registry.add(std::make_unique<Operation>(scale(calls))), Error);
  CHECK(registry.operations().size() == 2);
}

}  // namespace
}  // namespace croquis
