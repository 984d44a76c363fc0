// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/chain.h"

#include <algorithm>

namespace croquis {

const PortDescription* main_input(const OperationDescription& operation) {
  return operation.inputs.empty() ? nullptr : &operation.inputs.front();
}

const PortDescription* main_output(const OperationDescription& operation) {
  const auto found =
      std::ranges::find_if(operation.outputs, [](const auto& port) { return port.type != ValueType::Report; });
  return found == operation.outputs.end() ? nullptr : &*found;
}

Link main_link(const Node& node, const Registry& registry) {
  if (node.source) return {node.id, "value"};
  const Operation* operation = registry.find(node.operation);
  if (operation == nullptr) return {node.id, ""};
  const OperationDescription description = operation->describe();
  const PortDescription* port = main_output(description);
  return {node.id, port == nullptr ? "" : port->name};
}

std::optional<ValueType> main_type(const Node& node, const Registry& registry) {
  if (node.source) return node.source->type();
  const Operation* operation = registry.find(node.operation);
  if (operation == nullptr) return std::nullopt;
  const OperationDescription description = operation->describe();
  const PortDescription* port = main_output(description);
  return port == nullptr ? std::nullopt : std::optional(port->type);
}

namespace {

/// What the main input is linked to; 0 for none.
NodeId id_before(const Registry& registry, const Node& node) {
  const Operation* operation = node.source ? nullptr : registry.find(node.operation);
  if (operation == nullptr) return 0;
  const OperationDescription description = operation->describe();
  const PortDescription* port = main_input(description);
  const auto link = port == nullptr ? node.inputs.end() : node.inputs.find(port->name);
  return link == node.inputs.end() ? 0 : link->second.node;
}

}  // namespace

const Node* step_before(const Document& document, const Registry& registry, const Node& node) {
  const NodeId id = id_before(registry, node);
  return id == 0 ? nullptr : document.find(id);
}

std::vector<const Node*> steps_after(const Document& document, const Registry& registry, NodeId id) {
  std::vector<const Node*> steps;
  for (const auto& node : document.nodes()) {
    if (id_before(registry, *node) == id) steps.push_back(node.get());
  }
  return steps;
}

std::vector<NodeId> chain_to(const Document& document, const Registry& registry, NodeId end) {
  std::vector<NodeId> chain;
  for (const Node* node = document.find(end); node != nullptr; node = step_before(document, registry, *node)) {
    if (std::ranges::find(chain, node->id) != chain.end()) break;
    chain.push_back(node->id);
  }
  std::ranges::reverse(chain);
  return chain;
}

bool is_used(const Document& document, NodeId id) {
  return std::ranges::any_of(document.nodes(), [&](const auto& node) {
    return std::ranges::any_of(node->inputs, [&](const auto& input) { return input.second.node == id; });
  });
}

}  // namespace croquis
