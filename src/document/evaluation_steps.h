// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/document.h"
#include "croquis/document/evaluation.h"
#include "croquis/document/operation.h"

/// The steps of an evaluation.
namespace croquis {

struct OrderedNode {
  const Node* node = nullptr;
  bool in_circle = false;  ///< its links lead in a cycle, or from one cycle to another
};

/// A node and all it depends on, inputs before those who use them; nodes whose links lead in a cycle stand together
/// before the ones that depend on them. Empty when there is no such node. O(#nodes log #nodes), without recursion.
std::vector<OrderedNode> evaluation_order(const Document& document, NodeId target);

/// Names, types and values of all of them.
void add_content(ContentHasher& hasher, const ParameterValues& parameters);

void add_content(ContentHasher& hasher, const Affine3& transform);

/// Of nodes without an operation.
inline const OperationDescription no_operation{};

/// A node in the evaluation under way.
struct NodeState {
  const Node* node = nullptr;
  bool in_circle = false;
  const Operation* operation = nullptr;  ///< null for sources, and where the registry has none of that id
  const OperationDescription* description = &no_operation;  ///< of the operation

  std::shared_ptr<const Evaluation> evaluation;
};

using NodeStates = std::map<NodeId, const NodeState*>;

/// The links whose values the node uses, by port name: all of a node that is on. One that is off uses the first input
/// port that has the type of its first output and is linked, or none.
std::map<std::string, Link> used_inputs(const NodeState& state);

/// Whether the node is off and has an input to give in place of that output.
bool passes_on(const NodeState& state, const std::string& output);

/// Why a node can't be computed at all, each finding an error.
/// @param inputs those nodes that its links lead to, as far as they are there
Findings faults_of(const NodeState& state, const NodeStates& inputs);

/// Warns when the node was made with an older version of its operation than the one that computes it.
void add_version_warning(const NodeState& state, Findings& findings);

Finding no_such_node(NodeId id);

struct OperationOutcome {
  OperationResult result;  ///< of a failed operation: its findings as `warnings`, and no outputs
  bool failed = false;
  bool repeatable = true;  ///< false when the same inputs may well succeed at another time
};

/// Does some work and turns whatever it throws into findings.
/// @throws Cancelled alone
OperationOutcome guarded(const std::function<OperationResult()>& work, const Progress& progress);

/// Runs an operation in the same way.
/// @throws Cancelled alone
OperationOutcome run_guarded(const Operation& operation, const Values& inputs, const ParameterValues& parameters,
                             Context& context);

}  // namespace croquis
