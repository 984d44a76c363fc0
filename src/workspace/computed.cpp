// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/computed.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/workspace/chain.h"

namespace croquis {
namespace {

bool is_error(const Finding& finding) { return finding.severity == Severity::Error; }

bool is_waiting(const Finding& finding) { return finding.code == "E_INPUT_FAILED"; }

/// A value of a type that the object's chain gives on its way, nearest to its end, and where it belongs.
std::pair<Value, Affine3> unmoved_along(const Workspace& workspace, const WorkObject& object, ValueType type) {
  Affine3 later = object.placement.map();
  for (auto id = object.chain.rbegin(); id != object.chain.rend(); ++id) {
    const Node* node = workspace.session().document().find(*id);
    if (node == nullptr) return {};
    if (node->source) {
      if (node->source->type() != type) return {};
      return {*node->source, composed(later, node->transform)};
    }
    const auto found = workspace.result(*id);
    if (found != nullptr && !found->failed && found->quality == Quality::Final) {
      for (const auto& [port, value] : found->outputs) {
        if (value.type() == type && value.has_content()) return {value, later};
      }
    }
    later = composed(later, node->transform);
  }
  return {};
}

}  // namespace

std::shared_ptr<const PolyMesh> mesh_at(const Workspace& workspace, NodeId id) {
  const Node* node = workspace.session().document().find(id);
  if (node == nullptr) return nullptr;
  if (node->source) return mesh_in(*node);
  const OperationDescription* operation = workspace.description(node->operation);
  const auto evaluation = operation == nullptr ? nullptr : workspace.result(id);
  return evaluation ? mesh_of(*evaluation, *operation) : nullptr;
}

std::shared_ptr<const PolyMesh> final_mesh(const Workspace& workspace, const Document& document, NodeId id) {
  const Node* node = document.find(id);
  if (node == nullptr) return nullptr;
  if (node->source) return mesh_in(*node);
  const OperationDescription* operation = workspace.description(node->operation);
  const auto kept = operation == nullptr ? nullptr : workspace.evaluator().find(document, id);
  const bool is_final = kept && !kept->failed && kept->quality == Quality::Final;
  return is_final ? mesh_of(*kept, *operation) : nullptr;
}

bool is_computed(const Workspace& workspace, const Document& document) {
  const std::vector<WorkObject> objects = objects_of(document, workspace.registry());
  return std::ranges::all_of(objects, [&](const WorkObject& object) {
    const bool computes = object.visible && !object.mesh && !begins_empty(document, object);
    return !computes || workspace.evaluator().find(document, object.node) != nullptr;
  });
}

void compute(Workspace& workspace, const Document& document, NodeId id) {
  Progress progress;
  const auto evaluation = workspace.evaluator().evaluate(document, id, Quality::Final, progress);
  if (evaluation->failed) throw Error(evaluation->findings);
}

Value value_along(const Workspace& workspace, const WorkObject& object, ValueType type) {
  const auto [value, later] = unmoved_along(workspace, object, type);
  return value.transformed(later);
}

bool has_value_along(const Workspace& workspace, const WorkObject& object, ValueType type) {
  return unmoved_along(workspace, object, type).first.has_content();
}

bool has_cage(const Workspace& workspace) {
  return std::ranges::any_of(workspace.objects(), [](const WorkObject& object) { return object.cage != 0; });
}

BoundingBox placed_bounds(const Workspace& workspace, const WorkObject& object) {
  const BoundingBox own = workspace.own_bounds(object);
  return own ? BoundingBox(transformed(*own, object.placement.map())) : std::nullopt;
}

double length_of_one(const Workspace& workspace, const Node& node, const ParameterDescription& parameter) {
  const OperationDescription* operation = workspace.description(node.operation);
  const bool of_input = parameter.length == ParameterLength::Input;
  if (operation == nullptr || (!of_input && parameter.length != ParameterLength::Output)) return 0;
  const auto input = of_input ? node.inputs.find(operation->inputs.front().name) : node.inputs.end();
  if (of_input && input == node.inputs.end()) return 0;
  const Link link = of_input ? input->second : Link{node.id, operation->outputs.front().name};
  const auto found = workspace.result(link.node);
  const BoundingBox box =
      found && found->outputs.contains(link.output) ? bounds_of(found->outputs.at(link.output)) : std::nullopt;
  const WorkObject* object = workspace.object(node.id);
  const double placed = object == nullptr ? 1 : std::cbrt(std::abs(object->placement.scale.prod()));
  return box ? parameter.share * ((*box)[1] - (*box)[0]).norm() * placed : 0;
}

bool begins_empty(const Document& document, const WorkObject& object) {
  const Node* first = document.find(object.chain.front());
  const auto sketch = source_of<Drawing>(first);
  const auto sheet = source_of<PerspectiveDrawing>(first);
  const auto network = source_of<AttributeNetwork>(first);
  return (sketch && sketch->strokes.empty()) || (sheet && sheet->strokes.empty()) ||
         (network && network->faces.empty());
}

std::vector<NodeFinding> findings_of(const Workspace& workspace) {
  std::vector<NodeFinding> findings;
  for (const WorkObject& object : workspace.objects()) {
    if (!object.result) continue;
    const Findings& of_object = object.result->findings;
    // Who waits is seen in the list of steps.
    const bool explained =
        std::ranges::any_of(of_object, [](const Finding& f) { return is_error(f) && !is_waiting(f); });
    for (const Finding& finding : of_object) {
      if (explained && is_waiting(finding)) continue;
      findings.push_back({is_error(finding) ? failing_step(workspace, object.node) : object.node, finding});
    }
  }
  std::stable_partition(findings.begin(), findings.end(), [](const NodeFinding& f) { return is_error(f.finding); });
  return findings;
}

NodeId failing_step(const Workspace& workspace, NodeId step) {
  const auto kept = workspace.evaluator().find(workspace.session().document(), step);
  if (!kept) return step;
  const auto waiting = std::ranges::find_if(kept->findings, is_waiting);
  return waiting == kept->findings.end() ? step : failing_step(workspace, std::stoull(waiting->subjects.front().id));
}

KeptResults kept_results(const Workspace& workspace) {
  const Document& document = workspace.session().document();
  const Registry& registry = workspace.registry();
  KeptResults kept;
  for (const WorkObject& object : workspace.objects()) {
    bool after_edits = false;
    for (const NodeId id : object.chain) {
      const Node& node = *document.find(id);
      after_edits = after_edits || edits_input(node, registry);
      const auto now = after_edits ? workspace.evaluator().find(document, id) : nullptr;
      if (!after_edits || (now && !now->failed)) continue;
      KeptResult of;
      const auto good = workspace.evaluator().last_good(id);
      const auto output = good ? good->outputs.find(main_link(node, registry).output) : Values::const_iterator();
      if (good && output != good->outputs.end()) of.result = output->second;
      if (auto input = workspace.edited_input(id)) of.edited = std::move(input);
      kept[id] = std::move(of);
    }
  }
  return kept;
}

}  // namespace croquis
