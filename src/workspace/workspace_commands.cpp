// SPDX-License-Identifier: GPL-3.0-or-later
// What people do to objects and to the steps of their chains.
#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/document/connectivity.h"
#include "croquis/edits/lines_by_position.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/node_values.h"
#include "croquis/workspace/object_names.h"
#include "croquis/workspace/workspace.h"

namespace croquis {
namespace {

[[noreturn]] void refuse_step(const std::string& sentence) {
  throw Error(make_error(Category::Usage, "E_STEP", sentence));
}

}  // namespace

void Workspace::load(Document document, bool modified) {
  live_.clear();
  views_.clear();
  active_ = 0;
  evaluator_.forget();
  objects_.clear();
  if (listener_.loaded) listener_.loaded();
  session_.load(std::move(document), modified);
  if (listener_.result_changed) listener_.result_changed();
  if (listener_.busy_changed) listener_.busy_changed(busy());
}

NodeId Workspace::add_source(const std::string& name, Value value) {
  const Document& before = session_.document();
  const NodeId id = before.next_id();
  Node node;
  node.name = free_name(before, name);
  node.source = std::move(value);
  Document document = before.with(std::move(node));
  // The first object of an empty document is no step of the history.
  if (before.nodes().empty() && session_.undo_labels().empty() && !session_.modified()) {
    load(std::move(document));
  } else {
    session_.edit("Open " + readable_name(name), std::move(document));
  }
  session_.select({{id, ""}});
  return id;
}

void Workspace::set_parameter(NodeId id, const std::string& name, const ParameterValue& value, bool dragging) {
  const Node* node = session_.document().find(id);
  const OperationDescription* operation = node == nullptr ? nullptr : description(node->operation);
  if (operation == nullptr) return;
  Document document = session_.document().with(with_values(*node, *operation, {{name, value}}));
  const std::string label = "Set " + name;
  if (dragging && !dragging_parameter_) session_.begin_drag(label);
  const bool in_drag = dragging || dragging_parameter_;
  dragging_parameter_ = dragging;
  if (!in_drag) {
    session_.edit(label, std::move(document));
    return;
  }
  session_.drag(std::move(document));
  if (!dragging) session_.end_drag();
}

void Workspace::remove_object(NodeId id) {
  const WorkObject* removed = object(id);
  if (removed == nullptr) return;
  const std::string name = removed->name;
  session_.edit("Delete " + readable_name(name), without_object(session_.document(), removed->node));
}

void Workspace::copy_object(NodeId id) {
  const WorkObject* copied = object(id);
  if (copied == nullptr) return;
  const std::string label = "Duplicate " + readable_name(copied->name);
  AddedNode added = with_object_copied(session_.document(), copied->node);
  edit_chain(label, std::move(added.document), added.node);
}

void Workspace::rename_object(NodeId id, const std::string& name) {
  const WorkObject* renamed = object(id);
  if (renamed == nullptr || name.empty() || name == renamed->name) return;
  Node node = *session_.document().find(renamed->chain.front());
  node.name = free_name(session_.document(), name);
  session_.edit("Rename " + readable_name(renamed->name), session_.document().with(std::move(node)));
}

void Workspace::show_object(NodeId id, bool visible) {
  const WorkObject* shown = object(id);
  if (shown == nullptr || shown->visible == visible) return;
  Node node = *session_.document().find(shown->node);
  node.visible = visible;
  session_.edit((visible ? "Show " : "Hide ") + readable_name(shown->name), session_.document().with(std::move(node)));
}

// ---- Steps

const Node& Workspace::step_node(NodeId step) const {
  const Node* node = session_.document().find(step);
  if (node == nullptr) refuse_step("There is no such step");
  return *node;
}

std::string Workspace::title_of(const Node& node) const {
  const OperationDescription* operation = description(node.operation);
  return operation == nullptr ? node.name : operation->title;
}

void Workspace::edit_chain(const std::string& label, Document document, NodeId selected) {
  session_.edit(label, std::move(document));
  if (session_.document().find(selected) == nullptr) return;
  if (const WorkObject* owner = object(selected)) active_ = owner->node;
  session_.select({{selected, ""}});
}

NodeId Workspace::add_step(NodeId after, const std::string& operation, const ParameterValues& parameters) {
  AddedNode added = with_step(session_.document(), registry_, after, operation, parameters);
  const WorkObject* owner = object(after);
  const std::string name = owner == nullptr ? step_node(after).name : owner->name;
  const std::string label = "Add " + title_of(*added.document.find(added.node)) + " to " + readable_name(name);
  edit_chain(label, std::move(added.document), added.node);
  return added.node;
}

void Workspace::remove_step(NodeId step) {
  const Node* before = step_before(session_.document(), registry_, step_node(step));
  const NodeId then = before == nullptr ? 0 : before->id;
  edit_chain("Delete " + title_of(step_node(step)), without_step(session_.document(), registry_, step), then);
}

void Workspace::enable_step(NodeId step, bool enabled) {
  edit_chain((enabled ? "Switch on " : "Switch off ") + title_of(step_node(step)),
             with_step_enabled(session_.document(), registry_, step, enabled), step);
}

void Workspace::move_step(NodeId step, int by) {
  edit_chain("Move " + title_of(step_node(step)), with_step_moved(session_.document(), registry_, step, by), step);
}

void Workspace::copy_step(NodeId step) {
  const std::string label = "Duplicate " + title_of(step_node(step));
  AddedNode added = with_step_copied(session_.document(), registry_, step);
  edit_chain(label, std::move(added.document), added.node);
}

void Workspace::freeze_step(NodeId step) {
  const Node& node = step_node(step);
  const auto kept = node.source ? nullptr : evaluator_.find(session_.document(), step);
  if (!kept || kept->failed || kept->quality != Quality::Final) {
    refuse_step('"' + title_of(node) +
                "\" can't be frozen before it is computed: wait for it, or mend what it reports");
  }
  const Link given = main_link(node, registry_);
  edit_chain("Freeze " + title_of(node),
             with_step_frozen(session_.document(), registry_, step, kept->outputs.at(given.output)), step);
}

// ---- Steps of edits

std::shared_ptr<const PolyMesh> Workspace::input_of_edits(NodeId step) const {
  const Node& node = step_node(step);
  if (!edits_input(node, registry_)) refuse_step('"' + node.name + "\" has no edits to apply again");
  const Node* before = step_before(session_.document(), registry_, node);
  auto mesh = before == nullptr ? nullptr : final_mesh(session_.document(), before->id);
  if (!mesh) refuse_step('"' + title_of(node) + "\" can't be applied again before the step before it is computed");
  return mesh;
}

void Workspace::apply_edits_again(NodeId step, const std::string& lines) {
  const auto input = input_of_edits(step);
  Node node = step_node(step);
  const InputEdits names = *description(node.operation)->edits_input;
  node.parameters[names.lines] = lines;
  node.parameters[names.connectivity] = connectivity_name(*input);
  const std::string label = "Re-apply " + title_of(node);
  Document document = session_.document().with(std::move(node));
  compute_mesh(document, step);
  edit_chain(label, std::move(document), step);
}

void Workspace::reapply_step(NodeId step) {
  input_of_edits(step);
  const Node& node = step_node(step);
  const ParameterValues values = complete(description(node.operation)->parameters, node.parameters);
  apply_edits_again(step, text_of(values, description(node.operation)->edits_input->lines));
}

void Workspace::reapply_step_by_position(NodeId step) {
  const auto now = input_of_edits(step);
  const Node& node = step_node(step);
  const InputEdits names = *description(node.operation)->edits_input;
  const ParameterValues values = complete(description(node.operation)->parameters, node.parameters);
  const auto noted = edited_inputs_.find(step);
  const auto before = noted == edited_inputs_.end() ? nullptr : noted->second.lock();
  if (!before || connectivity_name(*before) != text_of(values, names.connectivity)) {
    refuse_step("The mesh that \"" + title_of(node) +
                "\" was made for isn't kept any more, so the places of its elements aren't known: undo the change "
                "before it, or re-apply it by number");
  }
  const auto lines = parse_edit_lines(text_of(values, names.lines), all_edits());
  Progress progress;
  apply_edits_again(step, to_text(lines_by_position(*before, *now, lines, all_edits(), progress)));
}

// ---- States

namespace {

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

ChainStep Workspace::step(NodeId id) const {
  const Node& node = step_node(id);
  ChainStep step{id, node.name, node.source ? std::string() : title_of(node), StepState::Source, {}};
  if (node.source) return step;
  const auto kept = evaluator_.find(session_.document(), id);
  const WorkObject* owner = object(id);
  const bool waits = owner != nullptr && begins_empty(*owner);
  step.state = !node.enabled                            ? StepState::Off
               : !kept                                  ? waits ? StepState::Waiting : StepState::Computing
               : !kept->failed                          ? StepState::Fresh
               : has_other_connectivity(kept->findings) ? StepState::NeedsAttention
               : kept->stale                            ? StepState::Stale
                                                        : StepState::Failed;
  if (kept && kept->failed) step.problem = first_error(kept->findings);
  return step;
}

std::vector<ChainStep> Workspace::steps_of(const WorkObject& object) const {
  std::vector<ChainStep> steps;
  for (const NodeId id : object.chain) steps.push_back(step(id));
  return steps;
}

}  // namespace croquis
