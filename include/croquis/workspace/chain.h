// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/document/registry.h"

/// Chains: what a node makes is the main input of the next one. Sketch → solid → subdivided → filled.
namespace croquis {

/// The input that a chain runs through: the first one; null for an operation without inputs.
const PortDescription* main_input(const OperationDescription& operation);

/// The output that a chain goes on from: the first one that isn't a report; null without such.
const PortDescription* main_output(const OperationDescription& operation);

/// The operation of a node; null for a source, and where the registry has none of that id.
const OperationDescription* operation_of(const Node& node, const Registry& registry);

/// The link to what the node gives to the next step: "value" of a source. Without a known operation the output is
/// empty.
Link main_link(const Node& node, const Registry& registry);

/// The link to what a step on that type would go on from: the main output where it is of that type, else the first
/// output that is; none where nothing is.
std::optional<Link> link_to(const Node& node, const Registry& registry, ValueType type);

/// The type of the main output; none where the operation isn't known or gives reports alone.
std::optional<ValueType> main_type(const Node& node, const Registry& registry);

/// The node that the main input of a node is linked to, or null.
const Node* step_before(const Document& document, const Registry& registry, const Node& node);

/// The nodes that have this one as their main input, in the document's order.
std::vector<const Node*> steps_after(const Document& document, const Registry& registry, NodeId id);

/// From the first node to `end`, each the main input of the next one. In a circle, each node once.
/// @return empty when there is no such node
std::vector<NodeId> chain_to(const Document& document, const Registry& registry, NodeId end);

/// Whether some input of another node is linked to it.
bool is_used(const Document& document, NodeId id);

}  // namespace croquis
