// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/session/session.h"

#include <algorithm>
#include <set>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/document/backdrop.h"
#include "croquis/document/byte_size.h"
#include "croquis/document/content_hash.h"

namespace croquis {
namespace {

bool same_source(const Node& a, const Node& b) {
  if (a.source == b.source) return true;
  return a.source && b.source && content_hash(*a.source) == content_hash(*b.source);
}

bool same_backdrop(const Node& a, const Node& b) {
  return a.backdrop == b.backdrop || (a.backdrop && b.backdrop && *a.backdrop == *b.backdrop);
}

bool same_content(const Node& a, const Node& b) {
  return a.id == b.id && a.name == b.name && a.operation == b.operation && a.version == b.version &&
         a.parameters == b.parameters && a.inputs == b.inputs && a.visible == b.visible && a.transform == b.transform &&
         a.enabled == b.enabled && a.placement == b.placement && a.group == b.group && same_backdrop(a, b) &&
         same_source(a, b);
}

bool same_content(const Document& a, const Document& b) {
  return std::equal(a.nodes().begin(), a.nodes().end(), b.nodes().begin(), b.nodes().end(),
                    [](const auto& left, const auto& right) { return left == right || same_content(*left, *right); });
}

/// What a node has and may share with others.
std::vector<Value> shared_by(const Node& node) {
  std::vector<Value> values;
  if (node.source) values.push_back(*node.source);
  if (node.backdrop) values.emplace_back(node.backdrop->picture);
  return values;
}

/// What keeping a document costs when its neighbour is kept anyway.
std::size_t bytes_beside(const Document& kept, const Document& neighbour) {
  std::set<std::shared_ptr<const Node>> shared_nodes(neighbour.nodes().begin(), neighbour.nodes().end());
  std::set<Value> shared_values;
  for (const auto& node : neighbour.nodes()) {
    for (Value& value : shared_by(*node)) shared_values.insert(std::move(value));
  }
  std::size_t bytes = kept.nodes().size() * sizeof(std::shared_ptr<const Node>);
  for (const auto& node : kept.nodes()) {
    if (shared_nodes.contains(node)) continue;
    bytes += byte_size(*node);
    for (const Value& value : shared_by(*node)) {
      if (shared_values.insert(value).second) bytes += byte_size(value);
    }
  }
  return bytes;
}

std::size_t bytes_beside(const KeptComponents& kept, const KeptComponents& neighbour) {
  return kept.selection == neighbour.selection ? 0 : kept.selection->elements.size() * sizeof(Index);
}

std::vector<std::string> labels(const auto& steps) {
  std::vector<std::string> texts;
  for (const auto& step : steps) texts.push_back(step.label);
  return texts;
}

}  // namespace

Session::Session(Document initial, std::size_t byte_cap) : document_(std::move(initial)), byte_cap_(byte_cap) {}

Session::Step Session::step_of_now(std::string label) const {
  return {std::move(label), document_, selection_, components_, state_, 0};
}

void Session::show(Document document, std::uint64_t state) {
  // Ids that an undone step gave away stay used: code that remembers one must not take a new node for it.
  const NodeId next_id = std::max(document_.next_id(), document.next_id());
  document_ = document.next_id() == next_id ? std::move(document) : Document::of(document.nodes(), next_id);
  state_ = state;
  selection_ = existing(std::move(selection_), document_);
  components_ = existing_components(std::move(components_), document_, false, find_mesh_);
  ++revision_;
}

void Session::take_components(ComponentSelection components) {
  components_.selection = std::make_shared<const ComponentSelection>(std::move(components));
  components_ = existing_components(std::move(components_), document_, true, find_mesh_);
}

void Session::report_change() {
  // By index: a listener may add another.
  for (std::size_t i = 0; i < listeners_.size(); ++i) {
    const auto listener = listeners_[i];
    listener();
  }
}

void Session::add_undo(Step step) {
  step.bytes = bytes_beside(step.document, document_) + bytes_beside(step.components, components_);
  undo_.push_back(std::move(step));
  redo_.clear();
  forget_beyond_cap();
}

void Session::edit(std::string label, Document edited) {
  end_drag();
  if (same_content(document_, edited)) return;
  Step before = step_of_now(std::move(label));
  show(std::move(edited), ++last_state_);
  add_undo(std::move(before));
  report_change();
}

void Session::edit(std::string label, Document edited, ComponentSelection components) {
  end_drag();
  if (same_content(document_, edited)) return select_components(std::move(components));
  Step before = step_of_now(std::move(label));
  show(std::move(edited), ++last_state_);
  take_components(std::move(components));
  add_undo(std::move(before));
  report_change();
}

void Session::begin_drag(std::string label) {
  end_drag();
  drag_ = step_of_now(std::move(label));
}

void Session::drag(Document edited) {
  if (!drag_) throw Error(make_error(Category::Internal, "E_INTERNAL", "A drag goes on that was never begun."));
  if (edited.nodes() == document_.nodes()) return;
  show(std::move(edited), ++last_state_);
  report_change();
}

void Session::end_drag() {
  if (!drag_) return;
  Step before = std::move(*drag_);
  drag_.reset();
  if (same_content(before.document, document_)) {
    state_ = before.state;
  } else {
    add_undo(std::move(before));
  }
  report_change();
}

void Session::cancel_drag() {
  if (!drag_) return;
  Step before = std::move(*drag_);
  drag_.reset();
  selection_ = std::move(before.selection);
  components_ = std::move(before.components);
  show(std::move(before.document), before.state);
  report_change();
}

void Session::travel(std::deque<Step>& from, std::deque<Step>& to) {
  if (from.empty()) return;
  Step step = std::move(from.back());
  from.pop_back();
  Step now = step_of_now(std::move(step.label));
  selection_ = std::move(step.selection);
  components_ = std::move(step.components);
  show(std::move(step.document), step.state);
  now.bytes = bytes_beside(now.document, document_) + bytes_beside(now.components, components_);
  to.push_back(std::move(now));
  forget_beyond_cap();
  report_change();
}

void Session::undo() {
  end_drag();
  travel(undo_, redo_);
}

void Session::redo() {
  end_drag();
  travel(redo_, undo_);
}

std::vector<std::string> Session::undo_labels() const { return labels(undo_); }

std::vector<std::string> Session::redo_labels() const {
  std::vector<std::string> texts = labels(redo_);
  std::reverse(texts.begin(), texts.end());
  return texts;
}

std::size_t Session::history_bytes() const {
  std::size_t bytes = 0;
  for (const Step& step : undo_) bytes += step.bytes;
  for (const Step& step : redo_) bytes += step.bytes;
  return bytes;
}

void Session::forget_beyond_cap() {
  std::size_t bytes = history_bytes();
  while (bytes > byte_cap_ && undo_.size() + redo_.size() > 1) {
    std::deque<Step>& steps = undo_.empty() ? redo_ : undo_;
    bytes -= steps.front().bytes;
    steps.pop_front();
  }
}

void Session::select(Selection selection) {
  selection = existing(std::move(selection), document_);
  if (selection == selection_) return;
  selection_ = std::move(selection);
  ++revision_;
  report_change();
}

void Session::select_components(ComponentSelection components) {
  const auto before = components_.selection;
  take_components(std::move(components));
  if (*components_.selection == *before) {
    components_.selection = before;
    return;
  }
  ++revision_;
  report_change();
}

void Session::check_components() {
  const auto before = components_.selection;
  components_ = existing_components(std::move(components_), document_, false, find_mesh_);
  if (components_.selection == before) return;
  ++revision_;
  report_change();
}

void Session::mark_saved() {
  if (!modified()) return;
  saved_state_ = state_;
  report_change();
}

void Session::load(Document document, bool modified, std::vector<PastDocument> past) {
  drag_.reset();
  undo_.clear();
  redo_.clear();
  selection_.clear();
  components_ = {std::make_shared<const ComponentSelection>(), 0, 0};
  document_ = std::move(document);
  state_ = ++last_state_;
  saved_state_ = modified ? ++last_state_ : state_;
  for (std::size_t i = 0; i < past.size(); ++i) {
    const Document& next = i + 1 < past.size() ? past[i + 1].document : document_;
    const std::size_t bytes = bytes_beside(past[i].document, next);
    undo_.push_back({std::move(past[i].label), past[i].document, {}, components_, ++last_state_, bytes});
  }
  forget_beyond_cap();
  ++revision_;
  report_change();
}

std::vector<PastDocument> Session::past(std::size_t most) const {
  std::vector<PastDocument> past;
  for (std::size_t i = undo_.size() - std::min(most, undo_.size()); i < undo_.size(); ++i) {
    past.push_back({undo_[i].label, undo_[i].document});
  }
  return past;
}

void Session::on_change(std::function<void()> listener) { listeners_.push_back(std::move(listener)); }

}  // namespace croquis
