// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/chain_edit.h"

#include <algorithm>
#include <map>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/object_names.h"

namespace croquis {
namespace {

[[noreturn]] void refuse(const std::string& sentence, NodeId node) {
  throw Error(make_error(Category::Usage, "E_STEP", sentence,
                         {{SubjectKind::Node, std::to_string(node), std::nullopt, std::nullopt, {}}}));
}

const Node& node_of(const Document& document, NodeId id) {
  const Node* node = document.find(id);
  if (node == nullptr) refuse("There is no such step", id);
  return *node;
}

std::string quoted(const Node& node) { return '"' + node.name + '"'; }

/// The operation of a step.
const OperationDescription& require_step(const Registry& registry, const Node& node) {
  if (node.source) refuse(quoted(node) + " isn't a step: it is what its chain begins with", node.id);
  const OperationDescription* operation = operation_of(node, registry);
  if (operation == nullptr) refuse("There is no operation \"" + node.operation + "\"", node.id);
  return *operation;
}

/// The main input port's name and type.
const PortDescription& input_of(const Registry& registry, const Node& node) {
  const PortDescription* port = main_input(require_step(registry, node));
  if (port == nullptr) refuse(quoted(node) + " works on nothing, so it has no place in a chain", node.id);
  return *port;
}

/// The node linked to another main input.
Node relinked(const Registry& registry, Node node, const Link& link) {
  node.inputs[input_of(registry, node).name] = link;
  return node;
}

/// All links to one output lead to another one.
Document with_links_moved(Document document, const Link& from, const Link& to, NodeId except) {
  const auto nodes = document.nodes();
  for (const auto& node : nodes) {
    Node moved = *node;
    bool changed = false;
    for (auto& [port, link] : moved.inputs) {
      if (link != from || node->id == except) continue;
      link = to;
      changed = true;
    }
    if (changed) document = document.with(std::move(moved));
  }
  return document;
}

/// Throws where a step after `id` takes another type than `given`.
void require_fit(const Document& document, const Registry& registry, NodeId id, const std::optional<ValueType>& given,
                 const std::string& what) {
  for (const Node* later : steps_after(document, registry, id)) {
    const PortDescription& port = input_of(registry, *later);
    if (given == port.type) continue;
    refuse(what + ": " + quoted(*later) + " needs a " + to_string(port.type), later->id);
  }
}

/// Takes away what nothing uses any more, beginning with these nodes.
Document without_unused(Document document, std::vector<NodeId> candidates) {
  while (!candidates.empty()) {
    const NodeId id = candidates.back();
    candidates.pop_back();
    const Node* node = document.find(id);
    if (node == nullptr || is_used(document, id)) continue;
    for (const auto& [port, link] : node->inputs) candidates.push_back(link.node);
    document = document.without(id);
  }
  return document;
}

std::vector<NodeId> inputs_of(const Node& node) {
  std::vector<NodeId> inputs;
  for (const auto& [port, link] : node.inputs) inputs.push_back(link.node);
  return inputs;
}

}  // namespace

AddedNode with_step(const Document& document, const Registry& registry, NodeId id, const std::string& operation,
                    const ParameterValues& parameters) {
  const Node& before = node_of(document, id);
  Node step;
  step.id = document.next_id();
  step.operation = operation;
  step.name = free_name(document, operation);
  step.parameters = parameters;
  const OperationDescription& description = require_step(registry, step);
  step.version = description.version;
  const PortDescription& port = input_of(registry, step);
  const std::optional<Link> from = link_to(before, registry, port.type);
  if (!from) {
    refuse(
        "\"" + description.title + "\" works on a " + to_string(port.type) + ", and " + quoted(before) + " gives none",
        id);
  }
  step.inputs[port.name] = *from;
  const NodeId added = step.id;
  const bool same_type = main_type(step, registry) == main_type(before, registry);
  const Link to = main_link(step, registry);
  Document edited = document.with(std::move(step));
  if (same_type) edited = with_links_moved(std::move(edited), main_link(before, registry), to, added);
  return {std::move(edited), added};
}

Document without_step(const Document& document, const Registry& registry, NodeId id) {
  const Node& step = node_of(document, id);
  const PortDescription& port = input_of(registry, step);
  const Node* before = step_before(document, registry, step);
  if (before == nullptr) refuse(quoted(step) + " can't be taken away alone: nothing is before it", id);
  require_fit(document, registry, id, main_type(*before, registry), quoted(step) + " can't be taken away");
  const Link given = step.inputs.at(port.name);
  const std::vector<NodeId> inputs = inputs_of(step);
  Document edited = with_links_moved(document, main_link(step, registry), main_link(*before, registry), id).without(id);
  std::vector<NodeId> others;
  std::ranges::copy_if(inputs, std::back_inserter(others), [&](NodeId input) { return input != given.node; });
  return without_unused(std::move(edited), std::move(others));
}

Document without_object(const Document& document, NodeId end) {
  const Node* node = document.find(end);
  if (node == nullptr) return document;
  return without_unused(document.without(end), inputs_of(*node));
}

bool can_be_off(const Document& document, const Registry& registry, NodeId id) {
  const Node* step = document.find(id);
  const OperationDescription* operation = step == nullptr ? nullptr : operation_of(*step, registry);
  const PortDescription* port = operation == nullptr ? nullptr : main_input(*operation);
  return port != nullptr && main_type(*step, registry) == port->type;
}

Document with_step_enabled(const Document& document, const Registry& registry, NodeId id, bool enabled) {
  Node step = node_of(document, id);
  require_step(registry, step);
  if (!enabled && !can_be_off(document, registry, id)) {
    refuse(quoted(step) + " can't be switched off: it makes another kind of thing than it is given", id);
  }
  step.enabled = enabled;
  return document.with(std::move(step));
}

namespace {

/// Exchanges two neighbours: `first` is the main input of `second`.
Document with_neighbours_exchanged(const Document& document, const Registry& registry, const Node& first,
                                   const Node& second) {
  const std::string sentence = quoted(second) + " can't come before " + quoted(first);
  const Node* before = step_before(document, registry, first);
  if (before == nullptr) refuse(sentence + ": nothing is before that", second.id);
  const auto fits = [&](const Node& giver, const Node& taker) {
    return main_type(giver, registry) == input_of(registry, taker).type;
  };
  const bool fit = fits(*before, second) && fits(second, first);
  if (!fit || steps_after(document, registry, first.id).size() > 1) {
    refuse(sentence + (fit ? ": another chain uses that, too" : ": it works on another kind of thing"), second.id);
  }
  require_fit(document, registry, second.id, main_type(first, registry), sentence);
  const Link given = first.inputs.at(input_of(registry, first).name);
  const Document passed = with_links_moved(document, main_link(second, registry), main_link(first, registry), first.id);
  const Node now_first = relinked(registry, *passed.find(second.id), given);
  const Node now_second = relinked(registry, *passed.find(first.id), main_link(second, registry));
  return passed.with(now_first).with(now_second);
}

}  // namespace

Document with_step_moved(const Document& document, const Registry& registry, NodeId id, int by) {
  const Node& step = node_of(document, id);
  input_of(registry, step);
  if (by < 0) {
    const Node* before = step_before(document, registry, step);
    if (before == nullptr || before->source) refuse(quoted(step) + " is the first step already", id);
    return with_neighbours_exchanged(document, registry, *before, step);
  }
  const std::vector<const Node*> after = steps_after(document, registry, id);
  if (after.empty()) refuse(quoted(step) + " is the last step already", id);
  return with_neighbours_exchanged(document, registry, step, *after.front());
}

AddedNode with_step_copied(const Document& document, const Registry& registry, NodeId id) {
  const Node step = node_of(document, id);
  require_step(registry, step);
  AddedNode added = with_step(document, registry, id, step.operation, step.parameters);
  Node copy = *added.document.find(added.node);
  copy.version = step.version;
  copy.enabled = step.enabled;
  for (const auto& [port, link] : step.inputs) copy.inputs.try_emplace(port, link);
  added.document = added.document.with(std::move(copy));
  return added;
}

AddedNode with_object_copied(const Document& document, NodeId end) {
  std::vector<NodeId> open{node_of(document, end).id};
  std::map<NodeId, NodeId> copies;  // by the original's id
  Document edited = document;
  while (!open.empty()) {
    const NodeId id = open.back();
    open.pop_back();
    const Node* node = document.find(id);
    if (node == nullptr || copies.contains(id)) continue;
    Node copy = *node;
    copy.id = 0;
    copy.name = free_name(edited, copy.name);
    copies[id] = edited.next_id();
    edited = edited.with(std::move(copy));
    for (const auto& [port, link] : node->inputs) open.push_back(link.node);
  }
  for (const auto& [original, id] : copies) {
    Node copy = *edited.find(id);
    for (auto& [port, link] : copy.inputs) {
      if (const auto found = copies.find(link.node); found != copies.end()) link.node = found->second;
    }
    edited = edited.with(std::move(copy));
  }
  return {std::move(edited), copies.at(end)};
}

Document with_step_frozen(const Document& document, const Registry& registry, NodeId id, Value value) {
  const Node& step = node_of(document, id);
  require_step(registry, step);
  const Link given = main_link(step, registry);
  for (const Node* later : steps_after(document, registry, id)) {
    if (later->inputs.at(input_of(registry, *later).name) == given) continue;
    refuse(quoted(step) + " can't be frozen: " + quoted(*later) + " goes on from another result of it", id);
  }
  Node frozen = step;
  frozen.operation.clear();
  frozen.parameters.clear();
  frozen.inputs.clear();
  frozen.version = 1;
  frozen.enabled = true;
  frozen.source = std::move(value);
  const Node& first = node_of(document, chain_to(document, registry, id).front());
  frozen.transform = {};  // what it gave has it
  frozen.placement = first.placement;
  frozen.group = first.group;
  const std::vector<NodeId> inputs = inputs_of(step);
  Document edited = with_links_moved(document, given, {id, "value"}, id).with(std::move(frozen));
  return without_unused(std::move(edited), inputs);
}

}  // namespace croquis
