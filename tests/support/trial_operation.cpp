// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/trial_operation.h"

#include <memory>
#include <utility>

namespace croquis::test {

OperationDescription mesh_to_mesh(std::string id, int version) {
  return {std::move(id),
          version,
          "Trial",
          "For tests.",
          {{"mesh", ValueType::Mesh, "The mesh."}},
          {{"mesh", ValueType::Mesh, "The result."}},
          {{"factor", ParameterType::Number, 2.0, -10, 10, {}, "", "How much larger."}}};
}

void add_operation(Registry& registry, OperationDescription description, Operation::Compute compute) {
  registry.add(std::make_unique<Operation>(std::move(description), std::move(compute)));
}

Value point(double x) {
  PolyMesh mesh;
  mesh.positions = {Vec3(x, 0, 0)};
  return std::make_shared<const PolyMesh>(std::move(mesh));
}

double x_of(const Value& value) { return value.as<PolyMesh>()->positions.front().x(); }

OperationResult scaled(const Values& inputs, const ParameterValues& parameters) {
  return {{{"mesh", point(x_of(inputs.at("mesh")) * std::get<double>(parameters.at("factor")))}}, {}};
}

Node source_node(Value value, std::string name) {
  Node node;
  node.name = std::move(name);
  node.source = std::move(value);
  return node;
}

Node operation_node(std::string operation, Link input, double factor, std::string name) {
  Node node;
  node.name = std::move(name);
  node.operation = std::move(operation);
  node.parameters["factor"] = factor;
  node.inputs["mesh"] = std::move(input);
  return node;
}

}  // namespace croquis::test
