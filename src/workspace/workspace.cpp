// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/workspace.h"

#include <algorithm>
#include <set>
#include <utility>

#include "croquis/workspace/chain.h"

namespace croquis {
namespace {

template <class Callback, class... Arguments>
void report(const Callback& callback, Arguments&&... arguments) {
  if (callback) callback(std::forward<Arguments>(arguments)...);
}

bool is_in(const std::vector<NodeId>& chain, NodeId node) { return std::ranges::find(chain, node) != chain.end(); }

}  // namespace

Workspace::Workspace(Registry registry, LiveEvaluation::Post post, Listener listener)
    : registry_(std::move(registry)),
      evaluator_(registry_, memory_cap),
      post_(std::move(post)),
      listener_(std::move(listener)),
      session_(Document(), history_cap) {
  for (const auto& operation : registry_.operations()) {
    OperationDescription description = operation->describe();
    descriptions_[description.id] = std::move(description);
  }
  session_.on_change([this] { follow_session(); });
}

Workspace::~Workspace() = default;

const OperationDescription* Workspace::description(const std::string& operation) const {
  const auto found = descriptions_.find(operation);
  return found == descriptions_.end() ? nullptr : &found->second;
}

const OperationDescription* Workspace::first_operation_on(ValueType type) const {
  for (const auto& operation : registry_.operations()) {
    const OperationDescription& known = descriptions_.at(operation->describe().id);
    const PortDescription* port = main_input(known);
    if (port != nullptr && port->type == type) return &known;
  }
  return nullptr;
}

std::vector<const OperationDescription*> Workspace::operations_on(NodeId id) const {
  std::vector<const OperationDescription*> fitting;
  const Node* node = session_.document().find(id);
  const auto type = node == nullptr ? std::nullopt : main_type(*node, registry_);
  for (const auto& operation : registry_.operations()) {
    const OperationDescription& known = descriptions_.at(operation->describe().id);
    const PortDescription* port = main_input(known);
    if (type && port != nullptr && port->type == *type) fitting.push_back(&known);
  }
  return fitting;
}

// ---- Objects

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

NodeId Workspace::active_step() const {
  const WorkObject* object = active();
  if (object == nullptr) return 0;
  for (const SelectedItem& item : session_.selection()) {
    const Node* node = session_.document().find(item.node);
    if (item.part.empty() && is_in(object->chain, item.node) && !node->source) return item.node;
  }
  return object->node;
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
  list_objects();
  report(listener_.changed);
  report(listener_.result_changed);
}

std::shared_ptr<const Evaluation> Workspace::result(NodeId node) const {
  const auto found = live_.find(node);
  if (found != live_.end() && found->second->result()) return found->second->result();
  return evaluator_.find(session_.document(), node);
}

std::shared_ptr<const PolyMesh> Workspace::mesh_at(NodeId id) const {
  const Node* node = session_.document().find(id);
  if (node == nullptr) return nullptr;
  if (node->source) return mesh_in(*node);
  const Operation* operation = registry_.find(node->operation);
  const auto evaluation = operation == nullptr ? nullptr : result(id);
  return evaluation ? mesh_of(*evaluation, *operation) : nullptr;
}

std::vector<NodeFinding> Workspace::findings() const {
  std::vector<NodeFinding> findings;
  for (const WorkObject& object : objects_) {
    if (!object.result) continue;
    for (const Finding& finding : object.result->findings) findings.push_back({object.node, finding});
  }
  std::stable_partition(findings.begin(), findings.end(),
                        [](const NodeFinding& f) { return f.finding.severity == Severity::Error; });
  return findings;
}

bool Workspace::busy() const {
  return std::ranges::any_of(live_, [](const auto& entry) { return entry.second->busy(); });
}

// ---- Evaluation

bool Workspace::begins_empty(const WorkObject& object) const {
  const Node* first = session_.document().find(object.chain.front());
  if (first == nullptr || !first->source) return false;
  const auto drawing = first->source->as<Drawing>();
  return drawing && drawing->strokes.empty();
}

bool Workspace::wants_evaluation(const WorkObject& object) const {
  if (object.is_source() || !object.visible) return false;
  if (object.cage != 0 && object.view == ChainView::Cage) return false;
  return !begins_empty(object);
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
  }
  follow_nodes(document);
  take_live_results();
}

void Workspace::follow_nodes(const Document& document) {
  std::set<NodeId> wanted;
  std::set<NodeId> empty;
  for (const WorkObject& object : objects_) {
    if (begins_empty(object)) empty.insert(object.node);
    if (!wants_evaluation(object)) continue;
    wanted.insert(object.node);
    live_node(object.node).follow(document);
  }
  const bool lost = std::erase_if(live_, [&](auto& entry) {
                      if (wanted.contains(entry.first)) return false;
                      entry.second->cancel();
                      // What is hidden is shown again at once; what lost its drawing can't be shown.
                      return document.find(entry.first) == nullptr || empty.contains(entry.first);
                    }) > 0;
  if (lost) report(listener_.result_changed);
}

void Workspace::take_live_results() {
  for (WorkObject& object : objects_) {
    const auto live = live_.find(object.node);
    if (live == live_.end() || !live->second->result()) continue;
    object.result = live->second->result();
    object.quality = live->second->quality();
    object.mesh = mesh_of(*object.result, *registry_.find(session_.document().find(object.node)->operation));
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
