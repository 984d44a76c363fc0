// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/workspace.h"

#include <algorithm>
#include <set>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/workspace/chain.h"

namespace croquis {
namespace {

template <class Callback, class... Arguments>
void report(const Callback& callback, Arguments&&... arguments) {
  if (callback) callback(std::forward<Arguments>(arguments)...);
}

bool is_error(const Finding& finding) { return finding.severity == Severity::Error; }

bool is_waiting(const Finding& finding) { return finding.code == "E_INPUT_FAILED"; }

bool is_in(const std::vector<NodeId>& chain, NodeId node) { return std::ranges::find(chain, node) != chain.end(); }

}  // namespace

Workspace::Workspace(Registry registry, LiveEvaluation::Post post, Listener listener)
    : registry_(std::move(registry)),
      evaluator_(registry_, memory_cap),
      post_(std::move(post)),
      listener_(std::move(listener)),
      session_(Document(), history_cap) {
  session_.find_meshes_with([this](const Document& document, NodeId node) { return final_mesh(document, node); });
  session_.on_change([this] { follow_session(); });
}

Workspace::~Workspace() = default;

namespace {

bool goes_on_from(const OperationDescription& operation, ValueType type) {
  const PortDescription* port = main_input(operation);
  return port != nullptr && port->type == type;
}

}  // namespace

const OperationDescription* Workspace::first_operation_on(ValueType type) const {
  const auto& all = registry_.descriptions();
  const auto found = std::ranges::find_if(all, [&](const auto& operation) { return goes_on_from(operation, type); });
  return found == all.end() ? nullptr : &*found;
}

std::vector<const OperationDescription*> Workspace::operations_on(NodeId id) const {
  std::vector<const OperationDescription*> fitting;
  const Node* node = session_.document().find(id);
  if (node == nullptr) return fitting;
  for (const OperationDescription& operation : registry_.descriptions()) {
    const PortDescription *taken = main_input(operation), *given = main_output(operation);
    const bool goes_on = taken != nullptr && link_to(*node, registry_, taken->type).has_value();
    if (goes_on && given != nullptr && given->type == ValueType::Mesh) fitting.push_back(&operation);
  }
  return fitting;
}

// ---- Objects

Value Workspace::value_along(const WorkObject& object, ValueType type) const {
  Affine3 later = object.placement.map();
  for (auto id = object.chain.rbegin(); id != object.chain.rend(); ++id) {
    const Node* node = session_.document().find(*id);
    if (node == nullptr) return {};
    if (node->source) {
      return node->source->type() == type ? node->source->transformed(composed(later, node->transform)) : Value();
    }
    const auto found = result(*id);
    if (found != nullptr && !found->failed && found->quality == Quality::Final) {
      for (const auto& [port, value] : found->outputs) {
        if (value.type() == type && value.has_content()) return value.transformed(later);
      }
    }
    later = composed(later, node->transform);
  }
  return {};
}

bool Workspace::has_cage() const {
  return std::ranges::any_of(objects_, [](const WorkObject& object) { return object.cage != 0; });
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

void Workspace::set_active(NodeId node) { active_ = node; }

NodeId Workspace::chosen_step(const WorkObject& object) const {
  for (const SelectedItem& item : session_.selection()) {
    const Node* node = session_.document().find(item.node);
    if (item.part.empty() && is_in(object.chain, item.node) && !node->source) return item.node;
  }
  return 0;
}

NodeId Workspace::active_step() const {
  const WorkObject* object = active();
  if (object == nullptr) return 0;
  const NodeId chosen = chosen_step(*object);
  return chosen == 0 ? object->node : chosen;
}

const Node* Workspace::active_operation() const {
  const Node* node = session_.document().find(active_step());
  return node == nullptr || node->source ? nullptr : node;
}

const Node* Workspace::step_with(const WorkObject& object, const std::string& operation) const {
  for (auto id = object.chain.rbegin(); id != object.chain.rend(); ++id) {
    const Node* node = session_.document().find(*id);
    if (node != nullptr && node->operation == operation) return node;
  }
  return nullptr;
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
  const auto found = live_.find(node);
  const auto newest = found == live_.end() ? nullptr : found->second->result();
  const bool is_followed = std::ranges::any_of(objects_, [&](const auto& o) { return evaluated_node(o) == node; });
  if (newest && is_followed) return newest;
  // What became a step within a chain, or is hidden, was left with the result that it had then.
  const auto kept = evaluator_.find(session_.document(), node);
  return kept ? kept : newest;
}

std::shared_ptr<const PolyMesh> Workspace::mesh_at(NodeId id) const {
  const Node* node = session_.document().find(id);
  if (node == nullptr) return nullptr;
  if (node->source) return mesh_in(*node);
  const OperationDescription* operation = description(node->operation);
  const auto evaluation = operation == nullptr ? nullptr : result(id);
  return evaluation ? mesh_of(*evaluation, *operation) : nullptr;
}

std::shared_ptr<const PolyMesh> Workspace::final_mesh(const Document& document, NodeId id) const {
  const Node* node = document.find(id);
  if (node == nullptr) return nullptr;
  if (node->source) return mesh_in(*node);
  const OperationDescription* operation = description(node->operation);
  const auto kept = operation == nullptr ? nullptr : evaluator_.find(document, id);
  const bool is_final = kept && !kept->failed && kept->quality == Quality::Final;
  return is_final ? mesh_of(*kept, *operation) : nullptr;
}

std::shared_ptr<const PolyMesh> Workspace::compute_mesh(const Document& document, NodeId id) {
  Progress progress;
  const auto evaluation = evaluator_.evaluate(document, id, Quality::Final, progress);
  if (evaluation->failed) throw Error(evaluation->findings);
  const OperationDescription* operation = operation_of(*document.find(id), registry_);
  return operation == nullptr ? mesh_in(*document.find(id)) : mesh_of(*evaluation, *operation);
}

std::vector<NodeFinding> Workspace::findings() const {
  std::vector<NodeFinding> findings;
  for (const WorkObject& object : objects_) {
    if (!object.result) continue;
    const Findings& of_object = object.result->findings;
    // Who waits is seen in the list of steps.
    const bool told = std::ranges::any_of(of_object, [](const Finding& f) { return is_error(f) && !is_waiting(f); });
    for (const Finding& finding : of_object) {
      if (told && is_waiting(finding)) continue;
      findings.push_back({is_error(finding) ? failing_step(object.node) : object.node, finding});
    }
  }
  std::stable_partition(findings.begin(), findings.end(), [](const NodeFinding& f) { return is_error(f.finding); });
  return findings;
}

/// The step that has to be mended before this one can be computed: maybe itself.
NodeId Workspace::failing_step(NodeId step) const {
  const auto kept = evaluator_.find(session_.document(), step);
  if (!kept) return step;
  const auto waiting = std::ranges::find_if(kept->findings, is_waiting);
  return waiting == kept->findings.end() ? step : failing_step(std::stoull(waiting->subjects.front().id));
}

bool Workspace::busy() const {
  return std::ranges::any_of(live_, [](const auto& entry) { return entry.second->busy(); });
}

// ---- Evaluation

bool Workspace::begins_empty(const WorkObject& object) const {
  const Node* first = session_.document().find(object.chain.front());
  const auto sketch = source_of<Drawing>(first);
  const auto sheet = source_of<PerspectiveDrawing>(first);
  const auto network = source_of<AttributeNetwork>(first);
  return (sketch && sketch->strokes.empty()) || (sheet && sheet->strokes.empty()) ||
         (network && network->faces.empty());
}

/// The node whose result is shown; 0 when nothing needs to be computed.
NodeId Workspace::evaluated_node(const WorkObject& object) const {
  if (!object.visible || begins_empty(object)) return 0;
  const NodeId shown = object.cage != 0 && object.view == ChainView::Cage ? object.cage : object.node;
  return session_.document().find(shown)->source ? 0 : shown;
}

LiveNode& Workspace::live_node(NodeId node) {
  std::unique_ptr<LiveNode>& live = live_[node];
  if (live) return *live;
  LiveNode::Host host;
  host.post = post_;
  host.changed = [this] { take_results(); };
  host.progress = [this](double fraction, const std::string& step) {
    if (!held_) report(listener_.progress, fraction, step);
  };
  host.busy_changed = [this] {
    if (!held_) report(listener_.busy_changed, busy());
  };
  live = std::make_unique<LiveNode>(evaluator_, node, std::move(host));
  return *live;
}

std::unique_ptr<LiveNode> Workspace::live_beside(NodeId id, std::function<void()> changed) {
  LiveNode::Host host;
  host.post = post_;
  host.changed = std::move(changed);
  host.progress = [](double, const std::string&) {};
  host.busy_changed = [] {};
  return std::make_unique<LiveNode>(evaluator_, id, std::move(host));
}

void Workspace::list_objects() {
  const Document& document = session_.document();
  objects_ = objects_of(document, registry_);
  for (WorkObject& object : objects_) {
    if (const auto view = views_.find(object.node); view != views_.end()) object.view = view->second;
    if (!isolated_.empty() && !isolated_.contains(object.chain.front())) object.visible = false;
  }
  choose_cages();
  std::vector<NodeId> evaluated;
  for (const auto& [node, live] : live_) evaluated.push_back(node);
  follow_nodes(document);
  take_live_results();
  fill_cages();
  note_edited_inputs();
  const bool lost = std::ranges::any_of(evaluated, [&](NodeId node) { return !live_.contains(node); });
  if (lost) report(listener_.result_changed);
}

/// Of the active object: by the step that is chosen.
void Workspace::choose_cages() {
  const WorkObject* current = active();
  for (WorkObject& object : objects_) {
    if (&object != current) continue;
    object.editable = editable_node(session_.document(), registry_, object.chain, chosen_step(object));
    if (object.cage != 0 || edits_elements_) object.cage = object.editable;
  }
}

/// Computed cages: what is known to be right, else the newest there is.
void Workspace::fill_cages() {
  for (WorkObject& object : objects_) {
    if (object.cage == 0) continue;
    const auto exact = final_mesh(session_.document(), object.cage);
    object.cage_mesh = exact ? exact : mesh_at(object.cage);
    if (!exact || object.cage != object.node || session_.document().find(object.node)->source) continue;
    object.mesh = exact;
    object.result = evaluator_.find(session_.document(), object.node);
    object.quality = Quality::Final;
  }
}

void Workspace::note_edited_inputs() {
  const Document& document = session_.document();
  for (const auto& node : document.nodes()) {
    if (!edits_input(*node, registry_) || !final_mesh(document, node->id)) continue;
    const Node* before = step_before(document, registry_, *node);
    if (before != nullptr) edited_inputs_[node->id] = final_mesh(document, before->id);
  }
}

void Workspace::follow_nodes(const Document& document) {
  std::set<NodeId> wanted;
  std::set<NodeId> empty;
  for (const WorkObject& object : objects_) {
    if (begins_empty(object)) empty.insert(object.node);
    const NodeId evaluated = evaluated_node(object);
    if (evaluated == 0) continue;
    wanted.insert(evaluated);
    live_node(evaluated).follow(document);
  }
  std::erase_if(live_, [&](auto& entry) {
    if (wanted.contains(entry.first)) return false;
    entry.second->pause();
    // What is hidden is shown again at once; what lost its drawing can't be shown.
    return document.find(entry.first) == nullptr || empty.contains(entry.first);
  });
}

void Workspace::take_live_results() {
  for (WorkObject& object : objects_) {
    const auto live = live_.find(object.node);
    const OperationDescription* operation = description(session_.document().find(object.node)->operation);
    // A step that was frozen is a source now, though its last result is still there.
    if (live == live_.end() || !live->second->result() || operation == nullptr) continue;
    object.result = live->second->result();
    object.quality = live->second->quality();
    object.mesh = mesh_of(*object.result, *operation);
  }
}

void Workspace::follow_session() {
  evaluator_.set_byte_cap(memory_cap - std::min(session_.history_bytes(), history_cap));
  list_objects();
  if (const WorkObject* chosen = active()) active_ = chosen->node;
  report(listener_.changed);
}

void Workspace::take_results() {
  results_wait_ = held_;
  if (held_) return;
  session_.check_components();
  list_objects();
  report(listener_.result_changed);
}

void Workspace::hold_results(bool held) {
  if (held == held_) return;
  held_ = held;
  if (held) return;
  if (std::exchange(results_wait_, false)) take_results();
  report(listener_.busy_changed, busy());
}

void Workspace::cancel() {
  for (const auto& [id, live] : live_) live->cancel();
}

}  // namespace croquis
