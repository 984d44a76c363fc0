// SPDX-License-Identifier: GPL-3.0-or-later
// What people do to documents and to the steps of chains.
#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/document/connectivity.h"
#include "croquis/edits/apply_edits.h"
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

void Workspace::load(Document document, bool modified, KeptWork kept) {
  live_.clear();
  views_.clear();
  isolated_.clear();
  measured_.clear();
  active_ = 0;
  evaluator_.forget();
  edited_inputs_.clear();
  for (const auto& [id, of] : kept.results) {
    const Node* node = document.find(id);
    if (node == nullptr || node->source) continue;
    if (of.result.has_content()) evaluator_.keep_last_good(id, {{main_link(*node, registry_).output, of.result}});
    if (auto mesh = of.edited.as<PolyMesh>()) edited_inputs_[id] = std::move(mesh);
  }
  objects_.clear();
  if (listener_.loaded) listener_.loaded();
  session_.load(std::move(document), modified, std::move(kept.past));
  if (listener_.result_changed) listener_.result_changed();
  if (listener_.busy_changed) listener_.busy_changed(busy());
}

KeptResults Workspace::kept_results() const {
  KeptResults kept;
  for (const WorkObject& object : objects_) {
    bool after_edits = false;
    for (const NodeId id : object.chain) {
      const Node& node = step_node(id);
      after_edits = after_edits || edits_input(node, registry_);
      const auto now = after_edits ? evaluator_.find(session_.document(), id) : nullptr;
      if (!after_edits || (now && !now->failed)) continue;
      KeptResult of;
      const auto good = evaluator_.last_good(id);
      const auto output = good ? good->outputs.find(main_link(node, registry_).output) : Values::const_iterator();
      if (good && output != good->outputs.end()) of.result = output->second;
      if (const auto noted = edited_inputs_.find(id); noted != edited_inputs_.end()) of.edited = noted->second;
      kept[id] = std::move(of);
    }
  }
  return kept;
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

void Workspace::set_parameter(NodeId id, const std::string& name, const ParameterValue& value, bool dragging,
                              const std::string& label) {
  const Node* node = session_.document().find(id);
  const OperationDescription* operation = node == nullptr ? nullptr : description(node->operation);
  if (operation == nullptr) return;
  const ParameterDescription* parameter = find_parameter(operation->parameters, name);
  std::string step = label.empty() ? name : label;
  if (label.empty() && parameter != nullptr)
    step = dragging ? croquis::title_of(*parameter) : title_with(*parameter, value);
  Document document = session_.document().with(with_values(*node, *operation, {{name, value}}));
  if (dragging && !dragging_parameter_) session_.begin_drag(step);
  const bool in_drag = dragging || dragging_parameter_;
  dragging_parameter_ = dragging;
  if (!in_drag) {
    session_.edit(std::move(step), std::move(document));
    return;
  }
  session_.drag(std::move(document));
  if (!dragging) session_.end_drag();
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
  const bool old = kept && kept->stale;
  if (!old && (!kept || kept->failed || kept->quality != Quality::Final)) {
    refuse_step('"' + title_of(node) +
                "\" can't be frozen before it is computed: wait for it, or mend what it reports");
  }
  const Link given = main_link(node, registry_);
  edit_chain((old ? "Keep the shape of " : "Freeze ") + title_of(node),
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
  const std::string label = "Apply " + title_of(node) + " to the new mesh";
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
  const auto before = noted == edited_inputs_.end() ? nullptr : noted->second;
  if (!before || connectivity_name(*before) != text_of(values, names.connectivity)) {
    refuse_step("The mesh that \"" + title_of(node) +
                "\" was made for isn't kept any more, so the places of its elements aren't known: undo the change "
                "before it, apply it by number, or keep the shape");
  }
  const auto lines = parse_edit_lines(text_of(values, names.lines));
  Progress progress;
  apply_edits_again(step, to_text(lines_by_position(*before, *now, lines, progress)));
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
  ChainStep step{id, node.name, node.source ? std::string() : title_of(node), StepState::Source, {}, {}};
  if (node.source) return step;
  const auto kept = evaluator_.find(session_.document(), id);
  const WorkObject* owner = object(id);
  const bool waits = owner != nullptr && begins_empty(*owner);
  step.state = !node.enabled                            ? StepState::Off
               : !kept                                  ? waits ? StepState::Waiting : StepState::Computing
               : !kept->failed                          ? StepState::Fresh
               : failing_step(id) != id                 ? StepState::Held
               : has_other_connectivity(kept->findings) ? StepState::NeedsAttention
               : kept->stale                            ? StepState::Stale
                                                        : StepState::Failed;
  if (kept && kept->failed) step.problem = first_error(kept->findings);
  if (step.state == StepState::Held) {
    step.problem = kept->findings.back().message;  // what it waits for
    step.waits_for = title_of(step_node(failing_step(id)));
  }
  return step;
}

std::vector<ChainStep> Workspace::steps_of(const WorkObject& object) const {
  std::vector<ChainStep> steps;
  for (const NodeId id : object.chain) steps.push_back(step(id));
  return steps;
}

}  // namespace croquis
