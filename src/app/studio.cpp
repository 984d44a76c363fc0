// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio.h"

#include <QMetaObject>
#include <algorithm>
#include <set>
#include <utility>

#include "croquis/operators/all_operations.h"

namespace croquis::app {
namespace {

const std::string solid_operation_id = "inflate";

std::shared_ptr<const Drawing> drawing_of(const Node& node) {
  return node.source ? node.source->as<Drawing>() : nullptr;
}

std::set<NodeId> nodes_of(const Document& document) {
  std::set<NodeId> ids;
  for (const auto& node : document.nodes()) ids.insert(node->id);
  return ids;
}

}  // namespace

Studio::Studio() : registry_(all_operations()), evaluator_(registry_, memory_cap), session_(Document(), history_cap) {
  for (const auto& operation : registry_.operations()) {
    OperationDescription description = operation->describe();
    descriptions_[description.id] = std::move(description);
  }
  session_.on_change([this] { follow_session(); });
}

Studio::~Studio() = default;

const StudioObject* Studio::object(NodeId node) const {
  const auto found = std::find_if(objects_.begin(), objects_.end(),
                                  [&](const StudioObject& o) { return o.node == node || o.cage == node; });
  return node == 0 || found == objects_.end() ? nullptr : &*found;
}

const StudioObject* Studio::active() const {
  for (const SelectedItem& item : session_.selection()) {
    if (const StudioObject* selected = object(item.node)) return selected;
    if (item.node == drawing_node()) return object(solid_node());
  }
  if (const StudioObject* last = object(active_)) return last;
  return objects_.empty() ? nullptr : &objects_.front();
}

void Studio::set_active(NodeId node) { active_ = node; }

const Node* Studio::active_operation() const {
  const StudioObject* object = active();
  const Node* node = object == nullptr ? nullptr : session_.document().find(object->node);
  return node == nullptr || node->source ? nullptr : node;
}

const OperationDescription* Studio::description(const std::string& operation) const {
  const auto found = descriptions_.find(operation);
  return found == descriptions_.end() ? nullptr : &found->second;
}

void Studio::set_view(NodeId id, SmoothView view) {
  views_[id] = view;
  list_objects();
  emit changed();
  emit result_changed();
}

const Drawing& Studio::drawing() const {
  static const Drawing none;
  const Node* node = session_.document().find(drawing_node());
  return node == nullptr ? none : *drawing_of(*node);
}

NodeId Studio::drawing_node() const {
  for (const auto& node : session_.document().nodes()) {
    if (drawing_of(*node) != nullptr) return node->id;
  }
  return 0;
}

NodeId Studio::solid_node() const {
  for (const auto& node : session_.document().nodes()) {
    if (node->operation == solid_operation_id) return node->id;
  }
  return 0;
}

const OperationDescription* Studio::solid_description() const {
  return solid_node() == 0 ? nullptr : description(solid_operation_id);
}

std::shared_ptr<const Evaluation> Studio::result() const {
  const auto found = live_.find(solid_node());
  return found == live_.end() ? nullptr : found->second->result();
}

std::shared_ptr<const PolyMesh> Studio::solid() const {
  const auto evaluation = result();
  return evaluation ? mesh_of(*evaluation, *registry_.find(solid_operation_id)) : nullptr;
}

std::vector<NodeFinding> Studio::findings() const {
  std::vector<NodeFinding> findings;
  for (const StudioObject& object : objects_) {
    if (!object.result) continue;
    for (const Finding& finding : object.result->findings) findings.push_back({object.node, finding});
  }
  std::stable_partition(findings.begin(), findings.end(),
                        [](const NodeFinding& f) { return f.finding.severity == Severity::Error; });
  return findings;
}

bool Studio::busy() const {
  return std::any_of(live_.begin(), live_.end(), [](const auto& entry) { return entry.second->busy(); });
}

SketchToolOptions Studio::tool_options() const {
  SketchToolOptions options;
  options.operation = solid_operation_id;
  options.version = description(solid_operation_id)->version;
  return options;
}

void Studio::start_with(Drawing drawing) {
  SketchToolOptions options = tool_options();
  options.parameters.clear();  // files hold exact lines
  load(add_drawing(Document(), std::make_shared<const Drawing>(std::move(drawing)), options));
}

void Studio::start_empty() { load(Document()); }

void Studio::load(Document document, bool modified) {
  live_.clear();
  views_.clear();
  active_ = 0;
  evaluator_.forget();
  face_sets_ = FaceSets();
  objects_.clear();
  emit loaded();
  session_.load(std::move(document), modified);
  emit result_changed();
  emit busy_changed(busy());
}

NodeId Studio::add_mesh(const std::string& name, std::shared_ptr<const PolyMesh> mesh) {
  const Document& before = session_.document();
  const NodeId id = before.next_id();
  Node node;
  node.name = free_name(before, name);
  node.source = std::move(mesh);
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

void Studio::set_parameter(NodeId id, const std::string& name, const ParameterValue& value, bool dragging) {
  const Node* node = session_.document().find(id);
  const OperationDescription* operation = node == nullptr ? nullptr : description(node->operation);
  if (operation == nullptr) return;
  Node edited = *node;
  edited.parameters[name] = value;
  for (const ParameterDescription& parameter : operation->parameters) {
    if (parameter.name == name && parameter.default_value == value) edited.parameters.erase(name);
  }
  Document document = session_.document().with(std::move(edited));
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

void Studio::remove_object(NodeId id) {
  const StudioObject* removed = object(id);
  if (removed == nullptr) return;
  Document document = session_.document();
  const std::string name = removed->name;
  std::vector<NodeId> doomed{removed->node};
  while (!doomed.empty()) {
    const Node* node = document.find(doomed.back());
    doomed.pop_back();
    if (node == nullptr) continue;
    std::vector<NodeId> inputs;
    for (const auto& [port, link] : node->inputs) inputs.push_back(link.node);
    document = document.without(node->id);
    for (const NodeId input : inputs) {
      const bool used = std::any_of(document.nodes().begin(), document.nodes().end(), [&](const auto& other) {
        return std::any_of(other->inputs.begin(), other->inputs.end(),
                           [&](const auto& port) { return port.second.node == input; });
      });
      if (!used) doomed.push_back(input);
    }
  }
  session_.edit("Delete " + readable_name(name), std::move(document));
}

void Studio::rename_object(NodeId id, const std::string& name) {
  const StudioObject* renamed = object(id);
  if (renamed == nullptr || name.empty() || name == renamed->name) return;
  Node node = *session_.document().find(renamed->cage != 0 ? renamed->cage : renamed->node);
  node.name = free_name(session_.document(), name);
  session_.edit("Rename " + readable_name(renamed->name), session_.document().with(std::move(node)));
}

void Studio::show_object(NodeId id, bool visible) {
  const StudioObject* shown = object(id);
  if (shown == nullptr || shown->visible == visible) return;
  Node node = *session_.document().find(shown->node);
  node.visible = visible;
  session_.edit((visible ? "Show " : "Hide ") + readable_name(shown->name), session_.document().with(std::move(node)));
}

void Studio::hold_results(bool held) {
  if (held == held_) return;
  held_ = held;
  if (held) return;
  if (std::exchange(results_wait_, false)) take_results();
  emit busy_changed(busy());
}

void Studio::cancel() {
  for (const auto& [id, live] : live_) live->cancel();
}

bool Studio::wants_evaluation(const StudioObject& object) const {
  if (object.is_source() || !object.visible) return false;
  if (object.cage != 0) return object.view != SmoothView::Cage;
  return object.node != solid_node() || !drawing().strokes.empty();
}

LiveNode& Studio::live_node(NodeId node) {
  std::unique_ptr<LiveNode>& live = live_[node];
  if (live) return *live;
  LiveNode::Host host;
  host.post = [this](std::function<void()> task) {
    QMetaObject::invokeMethod(this, std::move(task), Qt::QueuedConnection);
  };
  host.changed = [this] { take_results(); };
  host.progress = [this](double fraction, const std::string& step) {
    if (!held_) emit progress_changed(fraction, QString::fromStdString(step));
  };
  host.busy_changed = [this] {
    if (!held_) emit busy_changed(busy());
  };
  live = std::make_unique<LiveNode>(evaluator_, node, std::move(host));
  return *live;
}

void Studio::list_objects() {
  const Document& document = session_.document();
  objects_ = objects_of(document, registry_);
  std::set<NodeId> wanted;
  for (StudioObject& object : objects_) {
    const auto view = views_.find(object.node);
    if (view != views_.end()) object.view = view->second;
    if (!wants_evaluation(object)) continue;
    wanted.insert(object.node);
    live_node(object.node).follow(document);
  }
  const std::set<NodeId> existing = nodes_of(document);
  const bool lost = std::erase_if(live_, [&](auto& entry) {
                      if (wanted.contains(entry.first)) return false;
                      entry.second->cancel();
                      // What is hidden is shown again at once; what lost its drawing can't be shown.
                      return !existing.contains(entry.first) || entry.first == solid_node();
                    }) > 0;
  for (StudioObject& object : objects_) {
    const auto live = live_.find(object.node);
    if (live == live_.end() || !live->second->result()) continue;
    object.result = live->second->result();
    object.quality = live->second->quality();
    object.mesh = mesh_of(*object.result, *registry_.find(session_.document().find(object.node)->operation));
  }
  if (lost) emit result_changed();
}

void Studio::follow_session() {
  evaluator_.set_byte_cap(memory_cap - std::min(session_.history_bytes(), history_cap));
  list_objects();
  if (const StudioObject* chosen = active()) active_ = chosen->node;
  emit changed();
}

void Studio::take_results() {
  results_wait_ = held_;
  if (held_) return;
  list_objects();
  emit result_changed();
}

}  // namespace croquis::app
