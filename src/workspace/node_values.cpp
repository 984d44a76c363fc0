// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/node_values.h"

namespace croquis {

const ParameterValue& value_of(const Node& node, const ParameterDescription& parameter) {
  const auto given = node.parameters.find(parameter.name);
  return given == node.parameters.end() ? parameter.default_value : given->second;
}

Node with_values(Node node, const OperationDescription& operation, const ParameterValues& values) {
  for (const auto& [name, value] : values) {
    const ParameterDescription* parameter = find_parameter(operation.parameters, name);
    if (parameter == nullptr) continue;
    if (parameter->default_value == value)
      node.parameters.erase(name);
    else
      node.parameters[name] = value;
  }
  return node;
}

}  // namespace croquis
