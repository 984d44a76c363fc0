// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/step_commands.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/document/connectivity.h"
#include "croquis/edits/apply_edits.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/computed.h"
#include "croquis/workspace/object_names.h"

namespace croquis {
namespace {

bool goes_on_from(const OperationDescription& operation, ValueType type) {
  const PortDescription* port = main_input(operation);
  return port != nullptr && port->type == type;
}

[[noreturn]] void refuse_step(const std::string& sentence) {
  throw Error(make_error(Category::Usage, "E_STEP", sentence));
}

const Node& step_node(const Workspace& workspace, NodeId step) {
  const Node* node = workspace.session().document().find(step);
  if (node == nullptr) refuse_step("There is no such step");
  return *node;
}

std::string title_of(const Workspace& workspace, const Node& node) {
  const OperationDescription* operation = workspace.description(node.operation);
  return operation == nullptr ? node.name : operation->title;
}

void edit_chain(Workspace& workspace, const std::string& label, Document document, NodeId selected) {
  workspace.session().edit(label, std::move(document));
  if (workspace.session().document().find(selected) == nullptr) return;
  if (const WorkObject* owner = workspace.object(selected)) workspace.set_active(owner->node);
  workspace.session().select({{selected, ""}});
}

std::shared_ptr<const PolyMesh> input_of_edits(const Workspace& workspace, NodeId step) {
  const Node& node = step_node(workspace, step);
  if (!edits_input(node, workspace.registry())) refuse_step('"' + node.name + "\" has no edits to apply again");
  const Node* before = step_before(workspace.session().document(), workspace.registry(), node);
  auto mesh = before == nullptr ? nullptr : final_mesh(workspace, workspace.session().document(), before->id);
  if (!mesh)
    refuse_step('"' + title_of(workspace, node) + "\" can't be applied again before the step before it is computed");
  return mesh;
}

void apply_edits_again(Workspace& workspace, NodeId step, const std::string& lines) {
  const auto input = input_of_edits(workspace, step);
  Node node = step_node(workspace, step);
  const InputEdits names = *workspace.description(node.operation)->edits_input;
  node.parameters[names.lines] = lines;
  node.parameters[names.connectivity] = connectivity_name(*input);
  const std::string label = "Apply " + title_of(workspace, node) + " to the new mesh";
  Document document = workspace.session().document().with(std::move(node));
  compute(workspace, document, step);
  edit_chain(workspace, label, std::move(document), step);
}

/// The first error among findings, or nothing.
std::string first_error(const Findings& findings) {
  const auto found = std::ranges::find(findings, Severity::Error, &Finding::severity);
  return found == findings.end() ? std::string() : found->message;
}

/// Whether edits were made for another mesh than they are given.
bool has_other_connectivity(const Findings& findings) {
  return std::ranges::find(findings, connectivity_code, &Finding::code) != findings.end();
}

}  // namespace

const OperationDescription* first_operation_on(const Registry& registry, ValueType type) {
  const auto& all = registry.descriptions();
  const auto found = std::ranges::find_if(all, [&](const auto& operation) { return goes_on_from(operation, type); });
  return found == all.end() ? nullptr : &*found;
}

std::vector<const OperationDescription*> operations_on(const Workspace& workspace, NodeId id) {
  std::vector<const OperationDescription*> fitting;
  const Node* node = workspace.session().document().find(id);
  if (node == nullptr) return fitting;
  for (const OperationDescription& operation : workspace.registry().descriptions()) {
    const PortDescription *taken = main_input(operation), *given = main_output(operation);
    const bool goes_on = taken != nullptr && link_to(*node, workspace.registry(), taken->type).has_value();
    if (goes_on && given != nullptr && given->type == ValueType::Mesh) fitting.push_back(&operation);
  }
  return fitting;
}

NodeId chosen_step(const Session& session, const WorkObject& object) {
  for (const SelectedItem& item : session.selection()) {
    const Node* node = session.document().find(item.node);
    const bool in_chain = std::ranges::find(object.chain, item.node) != object.chain.end();
    if (item.part.empty() && in_chain && !node->source) return item.node;
  }
  return 0;
}

NodeId active_step(const Workspace& workspace) {
  const WorkObject* object = workspace.active();
  if (object == nullptr) return 0;
  const NodeId chosen = chosen_step(workspace.session(), *object);
  return chosen == 0 ? object->node : chosen;
}

const Node* active_operation(const Workspace& workspace) {
  const Node* node = workspace.session().document().find(active_step(workspace));
  return node == nullptr || node->source ? nullptr : node;
}

const Node* step_with(const Workspace& workspace, const WorkObject& object, const std::string& operation) {
  for (auto id = object.chain.rbegin(); id != object.chain.rend(); ++id) {
    const Node* node = workspace.session().document().find(*id);
    if (node != nullptr && node->operation == operation) return node;
  }
  return nullptr;
}

ChainStep step_at(const Workspace& workspace, NodeId id) {
  const Node& node = step_node(workspace, id);
  ChainStep step{id, node.name, node.source ? std::string() : title_of(workspace, node), StepState::Source, {}, {}};
  if (node.source) return step;
  const auto kept = workspace.evaluator().find(workspace.session().document(), id);
  const WorkObject* owner = workspace.object(id);
  const bool waits = owner != nullptr && begins_empty(workspace.session().document(), *owner);
  step.state = !node.enabled                            ? StepState::Off
               : !kept                                  ? waits ? StepState::Waiting : StepState::Computing
               : !kept->failed                          ? StepState::Fresh
               : failing_step(workspace, id) != id      ? StepState::Held
               : has_other_connectivity(kept->findings) ? StepState::NeedsAttention
               : kept->stale                            ? StepState::Stale
                                                        : StepState::Failed;
  if (kept && kept->failed) step.problem = first_error(kept->findings);
  if (step.state == StepState::Held) {
    step.problem = kept->findings.back().message;  // what it waits for
    step.waits_for = title_of(workspace, step_node(workspace, failing_step(workspace, id)));
  }
  return step;
}

std::vector<ChainStep> steps_of(const Workspace& workspace, const WorkObject& object) {
  std::vector<ChainStep> steps;
  for (const NodeId id : object.chain) steps.push_back(step_at(workspace, id));
  return steps;
}

NodeId add_step(Workspace& workspace, NodeId after, const std::string& operation, const ParameterValues& parameters) {
  AddedNode added = with_step(workspace.session().document(), workspace.registry(), after, operation, parameters);
  const WorkObject* owner = workspace.object(after);
  const std::string name = owner == nullptr ? step_node(workspace, after).name : owner->name;
  const std::string label =
      "Add " + title_of(workspace, *added.document.find(added.node)) + " to " + readable_name(name);
  edit_chain(workspace, label, std::move(added.document), added.node);
  return added.node;
}

void remove_step(Workspace& workspace, NodeId step) {
  const Node* before = step_before(workspace.session().document(), workspace.registry(), step_node(workspace, step));
  const NodeId then = before == nullptr ? 0 : before->id;
  edit_chain(workspace, "Delete " + title_of(workspace, step_node(workspace, step)),
             without_step(workspace.session().document(), workspace.registry(), step), then);
}

void enable_step(Workspace& workspace, NodeId step, bool enabled) {
  edit_chain(workspace, (enabled ? "Switch on " : "Switch off ") + title_of(workspace, step_node(workspace, step)),
             with_step_enabled(workspace.session().document(), workspace.registry(), step, enabled), step);
}

void move_step(Workspace& workspace, NodeId step, int by) {
  edit_chain(workspace, "Move " + title_of(workspace, step_node(workspace, step)),
             with_step_moved(workspace.session().document(), workspace.registry(), step, by), step);
}

void copy_step(Workspace& workspace, NodeId step) {
  const std::string label = "Duplicate " + title_of(workspace, step_node(workspace, step));
  AddedNode added = with_step_copied(workspace.session().document(), workspace.registry(), step);
  edit_chain(workspace, label, std::move(added.document), added.node);
}

void freeze_step(Workspace& workspace, NodeId step) {
  const Node& node = step_node(workspace, step);
  const auto kept = node.source ? nullptr : workspace.evaluator().find(workspace.session().document(), step);
  const bool old = kept && kept->stale;
  if (!old && (!kept || kept->failed || kept->quality != Quality::Final)) {
    refuse_step('"' + title_of(workspace, node) +
                "\" can't be frozen before it is computed: wait for it, or mend what it reports");
  }
  const Link given = main_link(node, workspace.registry());
  edit_chain(
      workspace, (old ? "Keep the shape of " : "Freeze ") + title_of(workspace, node),
      with_step_frozen(workspace.session().document(), workspace.registry(), step, kept->outputs.at(given.output)),
      step);
}

void reapply_step(Workspace& workspace, NodeId step) {
  input_of_edits(workspace, step);
  const Node& node = step_node(workspace, step);
  const ParameterValues values = complete(workspace.description(node.operation)->parameters, node.parameters);
  apply_edits_again(workspace, step, text_of(values, workspace.description(node.operation)->edits_input->lines));
}

void reapply_step_by_position(Workspace& workspace, NodeId step) {
  const auto now = input_of_edits(workspace, step);
  const Node& node = step_node(workspace, step);
  const InputEdits names = *workspace.description(node.operation)->edits_input;
  const ParameterValues values = complete(workspace.description(node.operation)->parameters, node.parameters);
  const auto before = workspace.edited_input(step);
  if (!before || connectivity_name(*before) != text_of(values, names.connectivity)) {
    refuse_step("The mesh that \"" + title_of(workspace, node) +
                "\" was made for isn't kept any more, so the places of its elements aren't known: undo the change "
                "before it, apply it by number, or keep the shape");
  }
  const auto lines = parse_edit_lines(text_of(values, names.lines));
  Progress progress;
  apply_edits_again(workspace, step, to_text(lines_by_position(*before, *now, lines, progress)));
}

}  // namespace croquis
