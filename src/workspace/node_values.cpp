// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/node_values.h"

namespace croquis {

ParameterValues values_of(const Node& node, const OperationDescription& operation) {
  return with_defaults(operation.parameters, node.parameters);
}

Node with_values(Node node, const OperationDescription& operation, const ParameterValues& values) {
  for (const auto& [name, value] : values) {
    const ParameterDescription* parameter = find_parameter(operation.parameters, name);
    if (parameter == nullptr) continue;
    if (is_given(*parameter, value))
      node.parameters[name] = value;
    else
      node.parameters.erase(name);
  }
  return node;
}

}  // namespace croquis
