// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/work_object.h"

#include <algorithm>
#include <set>

#include "croquis/workspace/chain.h"

namespace croquis {

std::shared_ptr<const PolyMesh> mesh_in(const Node& node) { return source_of<PolyMesh>(&node); }

std::shared_ptr<const PolyMesh> mesh_of(const Evaluation& evaluation, const OperationDescription& operation) {
  const PortDescription* port = main_output(operation);
  const auto output = port == nullptr ? evaluation.outputs.end() : evaluation.outputs.find(port->name);
  return output == evaluation.outputs.end() ? nullptr : output->second.as<PolyMesh>();
}

bool edits_input(const Node& node, const Registry& registry) {
  const OperationDescription* operation = operation_of(node, registry);
  return operation != nullptr && operation->edits_input.has_value();
}

NodeId editable_node(const Document& document, const Registry& registry, const std::vector<NodeId>& chain,
                     NodeId chosen) {
  const auto gives_mesh = [&](NodeId id) { return main_type(*document.find(id), registry) == ValueType::Mesh; };
  const auto edits = [&](NodeId id) { return edits_input(*document.find(id), registry); };
  auto at = std::ranges::find(chain, chosen);
  const bool counts = at != chain.end() && (edits(chosen) || (at != chain.begin() && at + 1 != chain.end()));
  if (counts && !edits(chosen)) --at;
  if (counts && gives_mesh(*at)) return *at;
  at = std::ranges::find_if(chain, gives_mesh);
  if (at == chain.end()) return 0;
  while (at + 1 != chain.end() && edits(*(at + 1))) ++at;
  return *at;
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
    object.editable = editable_node(document, registry, object.chain);
    const Node& first = *document.find(object.chain.front());
    if (first.source) object.name = first.name;
    object.group = first.group;
    object.placement = first.placement;
    object.begins_with_mesh = mesh_in(first) != nullptr;
    const bool edited =
        std::ranges::any_of(object.chain, [&](NodeId step) { return edits_input(*document.find(step), registry); });
    if (object.begins_with_mesh || edited) object.cage = object.editable;
    if (object.cage != 0) object.cage_mesh = mesh_in(*document.find(object.cage));
    objects.push_back(std::move(object));
  }
  return objects;
}

}  // namespace croquis
