// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/filling.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"

namespace croquis::app {
namespace {

const ParameterDescription* parameter_of(const Studio& studio, const Node& node, const std::string& name) {
  const OperationDescription* operation = studio.description(node.operation);
  if (operation == nullptr) return nullptr;
  const auto found = std::find_if(operation->parameters.begin(), operation->parameters.end(),
                                  [&](const auto& parameter) { return parameter.name == name; });
  return found == operation->parameters.end() ? nullptr : &*found;
}

/// The output of a node that chains go on from.
std::string mesh_output(const Studio& studio, const Node& node) {
  if (node.source) return "value";
  const OperationDescription* operation = studio.description(node.operation);
  if (operation == nullptr) return "mesh";
  const auto found = std::find_if(operation->outputs.begin(), operation->outputs.end(),
                                  [](const auto& port) { return port.type == ValueType::Mesh; });
  return found == operation->outputs.end() ? "mesh" : found->name;
}

}  // namespace

const Node* filling_node(const Studio& studio) {
  const Node* node = studio.active_operation();
  return node == nullptr || node->operation != filling_operation ? nullptr : node;
}

bool can_fill(const Studio& studio) {
  const WorkObject* object = studio.active();
  return object != nullptr && object->shown() != nullptr && studio.description(filling_operation) != nullptr;
}

void start_filling(Studio& studio) {
  if (filling_node(studio) != nullptr) return;
  if (!can_fill(studio)) {
    throw Error(make_error(Category::Usage, "E_EMPTY", "There is no mesh whose holes could be filled: open one first"));
  }
  const WorkObject& object = *studio.active();
  const OperationDescription& operation = *studio.description(filling_operation);
  const Document& before = studio.session().document();
  const Node& last = *before.find(object.node);
  Node node;
  node.name = free_name(before, filling_operation);
  node.operation = filling_operation;
  node.version = operation.version;
  node.parameters["select"] = std::string("none");
  node.inputs[operation.inputs.front().name] = {object.node, mesh_output(studio, last)};
  const NodeId id = before.next_id();
  studio.session().edit("Find holes of " + object.name, before.with(std::move(node)));
  studio.set_active(id);
  studio.session().select({{id, ""}});
}

ParameterValue filling_value(const Studio& studio, const Node& node, const std::string& parameter) {
  const auto given = node.parameters.find(parameter);
  if (given != node.parameters.end()) return given->second;
  const ParameterDescription* description = parameter_of(studio, node, parameter);
  return description == nullptr ? ParameterValue(std::string()) : description->default_value;
}

Document with_values(const Studio& studio, const Node& node, const ParameterValues& values) {
  Node edited = node;
  for (const auto& [name, value] : values) {
    const ParameterDescription* description = parameter_of(studio, node, name);
    if (description == nullptr) continue;
    if (description->default_value == value)
      edited.parameters.erase(name);
    else
      edited.parameters[name] = value;
  }
  return studio.session().document().with(std::move(edited));
}

}  // namespace croquis::app
