// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/studio_object.h"

#include <algorithm>
#include <set>

namespace croquis::app {
namespace {

/// The first port that carries meshes, or null.
const PortDescription* mesh_port(const std::vector<PortDescription>& ports) {
  const auto found =
      std::find_if(ports.begin(), ports.end(), [](const auto& port) { return port.type == ValueType::Mesh; });
  return found == ports.end() ? nullptr : &*found;
}

bool gives_mesh(const Node& node, const Registry& registry) {
  if (node.source) return type_of(*node.source) == ValueType::Mesh;
  const Operation* operation = registry.find(node.operation);
  return operation != nullptr && mesh_port(operation->describe().outputs) != nullptr;
}

/// Follows the meshes upstream to their source; null where they come from something else.
const Node* cage_of(const Document& document, const Registry& registry, const Node& end) {
  const Node* node = &end;
  for (std::size_t steps = 0; node != nullptr && steps <= document.nodes().size(); ++steps) {
    if (node->source) return mesh_in(*node) ? node : nullptr;
    const Operation* operation = registry.find(node->operation);
    if (operation == nullptr) return nullptr;
    const OperationDescription description = operation->describe();
    const PortDescription* port = mesh_port(description.inputs);
    const auto link = port == nullptr ? node->inputs.end() : node->inputs.find(port->name);
    node = link == node->inputs.end() ? nullptr : document.find(link->second.node);
  }
  return nullptr;
}

}  // namespace

std::shared_ptr<const PolyMesh> mesh_in(const Node& node) {
  if (!node.source) return nullptr;
  const auto* mesh = std::get_if<std::shared_ptr<const PolyMesh>>(&*node.source);
  return mesh == nullptr ? nullptr : *mesh;
}

std::shared_ptr<const PolyMesh> mesh_of(const Evaluation& evaluation, const Operation& operation) {
  const OperationDescription description = operation.describe();
  const PortDescription* port = mesh_port(description.outputs);
  const auto output = port == nullptr ? evaluation.outputs.end() : evaluation.outputs.find(port->name);
  if (output == evaluation.outputs.end()) return nullptr;
  return std::get<std::shared_ptr<const PolyMesh>>(output->second);
}

std::vector<StudioObject> objects_of(const Document& document, const Registry& registry) {
  std::set<NodeId> used;
  for (const auto& node : document.nodes()) {
    for (const auto& [port, link] : node->inputs) used.insert(link.node);
  }
  std::vector<StudioObject> objects;
  for (const auto& node : document.nodes()) {
    if (used.contains(node->id) || !gives_mesh(*node, registry)) continue;
    StudioObject object;
    object.node = node->id;
    object.name = node->name;
    object.visible = node->visible;
    object.mesh = mesh_in(*node);
    if (const Node* cage = cage_of(document, registry, *node)) {
      object.cage = cage->id;
      object.name = cage->name;
      object.cage_mesh = mesh_in(*cage);
    }
    objects.push_back(std::move(object));
  }
  return objects;
}

std::string readable_name(const std::string& name) {
  if (name.find('_') == std::string::npos) return name;
  std::string readable;
  for (const char c : name) {
    const bool gap = c == '_' || c == ' ';
    if (gap && (readable.empty() || readable.back() == ' ')) continue;
    readable += gap ? ' ' : c;
  }
  if (readable.ends_with(' ')) readable.pop_back();
  if (readable.empty()) return name;
  if (readable.front() >= 'a' && readable.front() <= 'z')
    readable.front() = static_cast<char>(readable.front() - 'a' + 'A');
  return readable;
}

std::string free_name(const Document& document, const std::string& wanted) {
  std::set<std::string> taken;
  for (const auto& node : document.nodes()) taken.insert(node->name);
  std::string name = wanted;
  for (int number = 2; taken.contains(name); ++number) name = wanted + " " + std::to_string(number);
  return name;
}

}  // namespace croquis::app
