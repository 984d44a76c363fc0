// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/evaluation_steps.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <new>
#include <set>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"

namespace croquis {
namespace {

/// The nodes that the target depends on, with the links among them.
struct Graph {
  struct Vertex {
    const Node* node = nullptr;
    std::set<NodeId> inputs;
    std::set<NodeId> users;
  };
  std::map<NodeId, Vertex> vertices;
};

Graph gather(const Document& document, NodeId target) {
  std::map<NodeId, const Node*> by_id;
  for (const auto& node : document.nodes()) by_id.emplace(node->id, node.get());
  Graph graph;
  std::vector<NodeId> pending;
  const auto reach = [&](NodeId id) {
    const auto found = by_id.find(id);
    if (found == by_id.end()) return false;
    if (graph.vertices.emplace(id, Graph::Vertex{found->second, {}, {}}).second) pending.push_back(id);
    return true;
  };
  reach(target);
  while (!pending.empty()) {
    const NodeId id = pending.back();
    pending.pop_back();
    for (const auto& [port, link] : graph.vertices.at(id).node->inputs) {
      if (!reach(link.node)) continue;
      graph.vertices.at(id).inputs.insert(link.node);
      graph.vertices.at(link.node).users.insert(id);
    }
  }
  return graph;
}

/// Takes out of the graph, one after the other, the vertices without neighbours on one side.
template <class Neighbours>
std::vector<NodeId> peel(std::map<NodeId, Graph::Vertex>& vertices, Neighbours before, Neighbours after) {
  std::vector<NodeId> peeled;
  for (const auto& [id, vertex] : vertices) {
    if ((vertex.*before).empty()) peeled.push_back(id);
  }
  for (std::size_t i = 0; i < peeled.size(); ++i) {
    for (const NodeId next : vertices.at(peeled[i]).*after) {
      const auto vertex = vertices.find(next);
      (vertex->second.*before).erase(peeled[i]);
      if ((vertex->second.*before).empty()) peeled.push_back(next);
    }
    vertices.erase(peeled[i]);
  }
  return peeled;
}

}  // namespace

std::vector<OrderedNode> evaluation_order(const Document& document, NodeId target) {
  Graph graph = gather(document, target);
  std::map<NodeId, const Node*> nodes;
  for (const auto& [id, vertex] : graph.vertices) nodes.emplace(id, vertex.node);

  std::vector<OrderedNode> order;
  for (const NodeId id : peel(graph.vertices, &Graph::Vertex::inputs, &Graph::Vertex::users)) {
    order.push_back({nodes.at(id), false});
  }
  const std::vector<NodeId> behind = peel(graph.vertices, &Graph::Vertex::users, &Graph::Vertex::inputs);
  for (const auto& [id, vertex] : graph.vertices) order.push_back({vertex.node, true});
  for (auto id = behind.rbegin(); id != behind.rend(); ++id) order.push_back({nodes.at(*id), false});
  return order;
}

namespace {

std::string in_quotes(const Node& node) {
  return "'" + (node.name.empty() ? "node " + std::to_string(node.id) : node.name) + "'";
}

/// As lists of steps name it: steps that nobody named have the title of what they do.
std::string label_of(const NodeState& state) {
  const bool unnamed = state.description != nullptr && state.node->name.starts_with(state.node->operation);
  return unnamed ? "'" + state.description->title + "'" : in_quotes(*state.node);
}

Finding fault(Category category, std::string code, std::string message, NodeId id) {
  return make_error(category, std::move(code), std::move(message),
                    {{SubjectKind::Node, std::to_string(id), {}, {}, {}}});
}

Finding off_fault(const Node& node) {
  return fault(Category::Geometry, "E_STEP_OFF",
               in_quotes(node) + " is off and has no input to give in place of its result: switch it on, or link one.",
               node.id);
}

Findings transform_faults(const Node& node) {
  if (node.transform.is_invertible()) return {};
  return {fault(Category::Geometry, "E_TRANSFORM",
                "The transform of " + in_quotes(node) + " flattens space or has a number that " + unusable_words +
                    ": give it a scale other than 0 along each axis.",
                node.id)};
}

/// Of what the node is, its links left aside.
Findings own_faults(const NodeState& state) {
  const Node& node = *state.node;
  if (node.source) {
    if (!node.source->has_content()) {
      return {fault(Category::Malformed, "E_NO_VALUE", in_quotes(node) + " has no value: import it again or remove it.",
                    node.id)};
    }
    return node.enabled ? transform_faults(node) : Findings{off_fault(node)};
  }
  if (node.operation.empty()) {
    return {fault(Category::Malformed, "E_NO_VALUE",
                  in_quotes(node) + " has neither a value nor an operation: remove it.", node.id)};
  }
  if (state.operation == nullptr) {
    return {fault(Category::Malformed, "E_OPERATION_UNKNOWN",
                  in_quotes(node) + " uses the operation '" + node.operation +
                      "', which this Croquis doesn't have: open it with a newer one.",
                  node.id)};
  }
  if (node.version > state.description->version) {
    return {fault(Category::Malformed, "E_OPERATION_NEWER",
                  in_quotes(node) + " was made with version " + std::to_string(node.version) + " of " +
                      state.description->title + "; this Croquis has version " +
                      std::to_string(state.description->version) + ": open it with a newer one.",
                  node.id)};
  }
  if (state.in_circle) {
    return {fault(Category::Malformed, "E_CYCLE",
                  "The inputs of " + in_quotes(node) + " lead back to itself: choose another input.", node.id)};
  }
  if (node.enabled) return transform_faults(node);
  return used_inputs(state).empty() ? Findings{off_fault(node)} : Findings{};
}

bool has_port(const OperationDescription& description, const std::string& name) {
  return std::any_of(description.inputs.begin(), description.inputs.end(),
                     [&](const PortDescription& port) { return port.name == name; });
}

/// Why an input failed, named for what waits for it as well: a host that shows this one alone has the reason.
void add_reasons(const Findings& of_input, Findings& findings) {
  for (const Finding& reason : of_input) {
    const bool known = std::ranges::any_of(findings, [&](const Finding& f) { return f.message == reason.message; });
    if (reason.severity == Severity::Error && reason.code != "E_INPUT_FAILED" && !known) findings.push_back(reason);
  }
}

void add_link_faults(const NodeState& state, const std::string& port, const Link& link, const NodeStates& inputs,
                     Findings& findings) {
  const Node& node = *state.node;
  const auto broken = [&](const std::string& why) {
    findings.push_back(fault(Category::Malformed, "E_LINK",
                             "The input '" + port + "' of " + in_quotes(node) + why + ": choose another one.",
                             node.id));
  };
  if (!has_port(*state.description, port)) {
    broken(" isn't one that " + state.description->title + " has");
    return;
  }
  const auto input = inputs.find(link.node);
  if (input == inputs.end()) {
    broken(" comes from node " + std::to_string(link.node) + ", which isn't there");
    return;
  }
  const NodeState& source = *input->second;
  if (!source.evaluation || source.evaluation->failed) {
    if (source.evaluation) add_reasons(source.evaluation->findings, findings);
    findings.push_back(fault(
        Category::Geometry, "E_INPUT_FAILED",
        label_of(state) + " waits for " + label_of(source) + ", which can't be computed: mend that, and this follows.",
        link.node));
    return;
  }
  if (source.evaluation->outputs.contains(link.output)) return;
  if (!source.node->enabled) {
    findings.push_back(fault(Category::Geometry, "E_STEP_OFF",
                             in_quotes(node) + " needs the output '" + link.output + "' of " + in_quotes(*source.node) +
                                 ", which is off: switch it on, or choose another input.",
                             link.node));
  } else {
    broken(" comes from the output '" + link.output + "' of " + in_quotes(*source.node) + ", which isn't there");
  }
}

}  // namespace

std::map<std::string, Link> used_inputs(const NodeState& state) {
  const Node& node = *state.node;
  if (node.enabled || state.description->outputs.empty()) return node.inputs;
  for (const PortDescription& port : state.description->inputs) {
    const auto input = node.inputs.find(port.name);
    if (port.type == state.description->outputs.front().type && input != node.inputs.end()) return {*input};
  }
  return {};
}

bool passes_on(const NodeState& state, const std::string& output) {
  return !state.node->enabled && !state.in_circle && !state.description->outputs.empty() &&
         state.description->outputs.front().name == output && !used_inputs(state).empty();
}

Findings faults_of(const NodeState& state, const NodeStates& inputs) {
  Findings findings = own_faults(state);
  if (!findings.empty() || state.node->source) return findings;
  for (const auto& [port, link] : used_inputs(state)) add_link_faults(state, port, link, inputs, findings);
  return findings;
}

void add_version_warning(const NodeState& state, Findings& findings) {
  if (state.node->version >= state.description->version) return;
  findings.push_back(make_warning(Category::Geometry, "W_OPERATION_OLDER",
                                  "Made with version " + std::to_string(state.node->version) + " of " +
                                      state.description->title + ", computed with version " +
                                      std::to_string(state.description->version) + ": compare the result."));
}

Finding no_such_node(NodeId id) {
  return fault(Category::Usage, "E_NODE", "There is no node " + std::to_string(id) + ".", id);
}

namespace {

OperationOutcome failure(Findings findings) {
  OperationOutcome outcome;
  outcome.failed = true;
  outcome.repeatable = std::none_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.code == "E_MEMORY" || finding.category == Category::Io;
  });
  outcome.result.warnings = std::move(findings);
  return outcome;
}

Finding internal(const std::string& reason) {
  return make_error(Category::Internal, "E_INTERNAL",
                    "Internal error (" + reason + "); please report it with the input.");
}

}  // namespace

OperationOutcome guarded(const std::function<OperationResult()>& work, const Progress& progress) {
  try {
    OperationOutcome outcome;
    outcome.result = work();
    return outcome;
  } catch (const Cancelled&) {
    if (progress.cancelled()) throw;
    return failure({internal("cancelled by nobody")});
  } catch (const Error& error) {
    return failure(error.findings());
  } catch (const std::bad_alloc&) {
    return failure({make_error(Category::Limit, "E_MEMORY",
                               "There is not enough memory for this; make the input smaller or free some memory.")});
  } catch (const std::exception& exception) {
    return failure({internal(exception.what())});
  }
}

OperationOutcome run_guarded(const Operation& operation, const Values& inputs, const ParameterValues& parameters,
                             Context& context) {
  return guarded([&] { return run(operation, inputs, parameters, context); }, context.progress);
}

}  // namespace croquis
