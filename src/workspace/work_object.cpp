// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/work_object.h"

#include <set>

#include "croquis/workspace/chain.h"

namespace croquis {

std::shared_ptr<const PolyMesh> mesh_in(const Node& node) {
  return node.source ? node.source->as<PolyMesh>() : nullptr;
}

std::shared_ptr<const PolyMesh> mesh_of(const Evaluation& evaluation, const Operation& operation) {
  const OperationDescription description = operation.describe();
  const PortDescription* port = main_output(description);
  const auto output = port == nullptr ? evaluation.outputs.end() : evaluation.outputs.find(port->name);
  return output == evaluation.outputs.end() ? nullptr : output->second.as<PolyMesh>();
}

std::vector<WorkObject> objects_of(const Document& document, const Registry& registry) {
  std::set<NodeId> used;
  for (const auto& node : document.nodes()) {
    for (const auto& [port, link] : node->inputs) used.insert(link.node);
  }
  std::vector<WorkObject> objects;
  for (const auto& node : document.nodes()) {
    if (used.contains(node->id) || main_type(*node, registry) != ValueType::Mesh) continue;
    WorkObject object;
    object.node = node->id;
    object.chain = chain_to(document, registry, node->id);
    object.name = node->name;
    object.visible = node->visible;
    object.mesh = mesh_in(*node);
    const Node& first = *document.find(object.chain.front());
    if (first.source) object.name = first.name;
    object.cage_mesh = mesh_in(first);
    if (object.cage_mesh) object.cage = first.id;
    objects.push_back(std::move(object));
  }
  return objects;
}

}  // namespace croquis
