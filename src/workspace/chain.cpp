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

const OperationDescription* operation_of(const Node& node, const Registry& registry) {
  return node.source ? nullptr : registry.description(node.operation);
}

namespace {

/// The output that a node's chain goes on from; null for sources, and without a known operation.
const PortDescription* output_of(const Node& node, const Registry& registry) {
  const OperationDescription* operation = operation_of(node, registry);
  return operation == nullptr ? nullptr : main_output(*operation);
}

}  // namespace

Link main_link(const Node& node, const Registry& registry) {
  if (node.source) return {node.id, "value"};
  const PortDescription* port = output_of(node, registry);
  return {node.id, port == nullptr ? "" : port->name};
}

std::optional<ValueType> main_type(const Node& node, const Registry& registry) {
  if (node.source) return node.source->type();
  const PortDescription* port = output_of(node, registry);
  return port == nullptr ? std::nullopt : std::optional(port->type);
}

std::optional<Link> link_to(const Node& node, const Registry& registry, ValueType type) {
  if (main_type(node, registry) == type) return main_link(node, registry);
  const OperationDescription* operation = operation_of(node, registry);
  if (operation == nullptr) return std::nullopt;
  const auto found = std::ranges::find(operation->outputs, type, &PortDescription::type);
  return found == operation->outputs.end() ? std::nullopt : std::optional(Link{node.id, found->name});
}

namespace {

/// What the main input is linked to; 0 for none.
NodeId id_before(const Registry& registry, const Node& node) {
  const OperationDescription* operation = operation_of(node, registry);
  const PortDescription* port = operation == nullptr ? nullptr : main_input(*operation);
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
