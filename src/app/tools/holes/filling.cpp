// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/filling.h"

#include <utility>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/workspace/node_values.h"
#include "croquis/workspace/object_names.h"

namespace croquis::app {
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
  if (MeshTopology(*object.shown()).boundary_loops().size() == 0) {
    throw Error(
        make_error(Category::Usage, "E_EMPTY",
                   readable_name(object.name) +
                       " has no holes: every edge has faces on both sides; to remesh it choose Object > Add step"));
  }
  AddedNode added = with_step(studio.session().document(), studio.registry(), object.node, filling_operation,
                              {{"select", std::string("none")}});
  studio.session().edit("Find holes of " + readable_name(object.name), std::move(added.document));
  studio.set_active(added.node);
  studio.session().select({{added.node, ""}});
}

ParameterValue filling_value(const Studio& studio, const Node& node, const std::string& parameter) {
  const OperationDescription* operation = studio.description(node.operation);
  const ParameterDescription* found = operation == nullptr ? nullptr : find_parameter(operation->parameters, parameter);
  return found == nullptr ? ParameterValue(std::string()) : values_of(node, *operation).at(parameter);
}

Document with_values(const Studio& studio, const Node& node, const ParameterValues& values) {
  const Document& document = studio.session().document();
  const OperationDescription* operation = studio.description(node.operation);
  return operation == nullptr ? document : document.with(croquis::with_values(node, *operation, values));
}

}  // namespace croquis::app
