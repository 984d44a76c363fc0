// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/workspace.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/computed.h"
#include "croquis/workspace/node_values.h"
#include "croquis/workspace/step_commands.h"

namespace croquis {
namespace {

template <class Callback, class... Arguments>
void report(const Callback& callback, Arguments&&... arguments) {
  if (callback) callback(std::forward<Arguments>(arguments)...);
}

bool is_in(const std::vector<NodeId>& chain, NodeId node) { return std::ranges::find(chain, node) != chain.end(); }

/// The node whose result is shown; 0 when nothing needs to be computed.
NodeId evaluated_node(const Document& document, const WorkObject& object) {
  if (!object.visible || begins_empty(document, object)) return 0;
  const NodeId shown = object.cage != 0 && object.view == ChainView::Cage ? object.cage : object.node;
  return document.find(shown)->source ? 0 : shown;
}

/// The newest result of an object, or none yet.
void take_live_result(WorkObject& object, const Workspace& workspace, const LiveNode* live) {
  const Node* node = workspace.session().document().find(object.node);
  const OperationDescription* operation = workspace.description(node->operation);
  // A step that was frozen is a source now, though its last result is still there.
  if (live == nullptr || !live->result() || operation == nullptr) return;
  object.result = live->result();
  object.quality = live->quality();
  object.mesh = mesh_of(*object.result, *operation);
}

/// Computed cages: what is known to be right, else the newest there is.
void fill_cage(WorkObject& object, const Workspace& workspace) {
  if (object.cage == 0) return;
  const Document& document = workspace.session().document();
  const auto exact = final_mesh(workspace, document, object.cage);
  object.cage_mesh = exact ? exact : mesh_at(workspace, object.cage);
  if (!exact || object.cage != object.node || document.find(object.node)->source) return;
  object.mesh = exact;
  object.result = workspace.evaluator().find(document, object.node);
  object.quality = Quality::Final;
}

/// The meshes that steps of edits fit now, which they edited last when they don't fit any more.
void note_edited_inputs(std::map<NodeId, std::shared_ptr<const PolyMesh>>& noted, const Workspace& workspace) {
  const Document& document = workspace.session().document();
  for (const auto& node : document.nodes()) {
    if (!edits_input(*node, workspace.registry()) || !final_mesh(workspace, document, node->id)) continue;
    const Node* before = step_before(document, workspace.registry(), *node);
    if (before != nullptr) noted[node->id] = final_mesh(workspace, document, before->id);
  }
}

}  // namespace

Workspace::Workspace(Registry registry, LiveEvaluation::Post post, Listener listener)
    : registry_(std::move(registry)),
      evaluator_(registry_, memory_cap),
      listener_(std::move(listener)),
      session_(Document(), history_cap,
               [this](const Document& document, NodeId node) { return final_mesh(*this, document, node); }),
      live_(evaluator_, std::move(post),
            {[this] {
               session_.check_components();
               list_objects();
               report(listener_.result_changed);
             },
             listener_.progress, listener_.busy_changed}) {
  session_.on_change([this] { follow_session(); });
}

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
  report(listener_.loaded);
  session_.load(std::move(document), modified, std::move(kept.past), std::move(kept.versions));
  report(listener_.result_changed);
  report(listener_.busy_changed, busy());
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
  if (!in_drag) return session_.edit(std::move(step), std::move(document));
  session_.drag(std::move(document));
  if (!dragging) session_.end_drag();
}

const WorkObject* Workspace::object(NodeId node) const {
  if (node == 0) return nullptr;
  auto found = std::ranges::find_if(objects_, [&](const auto& o) { return o.node == node || o.cage == node; });
  if (found == objects_.end()) {
    found = std::ranges::find_if(objects_, [&](const auto& o) { return is_in(o.chain, node); });
  }
  return found == objects_.end() ? nullptr : &*found;
}

const WorkObject* Workspace::active() const {
  const WorkObject* last = object(active_);
  for (const SelectedItem& item : session_.selection()) {
    // Of chains that share the selected node, the one that was worked on stays.
    if (last != nullptr && is_in(last->chain, item.node)) return last;
    if (const WorkObject* selected = object(item.node)) return selected;
  }
  if (last != nullptr) return last;
  return objects_.empty() ? nullptr : &objects_.front();
}

BoundingBox Workspace::own_bounds(const WorkObject& object) const {
  const auto& mesh = object.shown();
  if (!mesh) return std::nullopt;
  auto& measured = measured_[object.node];
  if (measured.first.lock() != mesh) measured = {mesh, bounds_of(*mesh)};
  return measured.second;
}

void Workspace::isolate(const std::vector<NodeId>& objects) {
  isolated_.clear();
  for (const NodeId node : objects) {
    if (const WorkObject* each = object(node)) isolated_.insert(each->chain.front());
  }
  list_again();
}

void Workspace::set_view(NodeId id, ChainView view) {
  views_[id] = view;
  list_again();
}

void Workspace::set_edits_elements(bool on) {
  if (edits_elements_ == on) return;
  edits_elements_ = on;
  list_again();
}

void Workspace::list_again() {
  list_objects();
  report(listener_.changed);
  report(listener_.result_changed);
}

std::shared_ptr<const Evaluation> Workspace::result(NodeId node) const {
  const LiveNode* live = live_.find(node);
  const auto newest = live == nullptr ? nullptr : live->result();
  const auto is_followed = [&](const WorkObject& each) { return evaluated_node(session_.document(), each) == node; };
  if (newest && std::ranges::any_of(objects_, is_followed)) return newest;
  // What became a step within a chain, or is hidden, was left with the result that it had then.
  const auto kept = evaluator_.find(session_.document(), node);
  return kept ? kept : newest;
}

std::shared_ptr<const PolyMesh> Workspace::edited_input(NodeId step) const {
  const auto noted = edited_inputs_.find(step);
  return noted == edited_inputs_.end() ? nullptr : noted->second;
}

void Workspace::list_objects() {
  const Document& document = session_.document();
  objects_ = objects_of(document, registry_);
  for (WorkObject& object : objects_) {
    if (const auto view = views_.find(object.node); view != views_.end()) object.view = view->second;
    if (!isolated_.empty() && !isolated_.contains(object.chain.front())) object.visible = false;
  }
  // The active object's cage depends on the step that is chosen.
  const WorkObject* current = active();
  std::set<NodeId> evaluated, empty;
  for (WorkObject& object : objects_) {
    if (&object == current) {
      object.editable = editable_node(document, registry_, object.chain, chosen_step(session_, object));
      if (object.cage != 0 || edits_elements_) object.cage = object.editable;
    }
    if (begins_empty(document, object)) empty.insert(object.node);
    if (const NodeId node = evaluated_node(document, object); node != 0) evaluated.insert(node);
  }
  // What is hidden is shown again at once; what lost its drawing can't be shown.
  const bool lost = live_.follow(document, evaluated, empty);
  for (WorkObject& object : objects_) take_live_result(object, *this, live_.find(object.node));
  for (WorkObject& object : objects_) fill_cage(object, *this);
  note_edited_inputs(edited_inputs_, *this);
  if (lost) report(listener_.result_changed);
}

void Workspace::follow_session() {
  evaluator_.set_byte_cap(memory_cap - std::min(session_.history_bytes(), history_cap));
  list_objects();
  if (const WorkObject* chosen = active()) active_ = chosen->node;
  report(listener_.changed);
}

}  // namespace croquis
