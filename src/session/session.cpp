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

std::size_t bytes_of(const auto& steps) {
  std::size_t bytes = 0;
  for (const auto& step : steps) bytes += step.bytes;
  return bytes;
}

std::vector<std::string> labels(const auto& steps) {
  std::vector<std::string> texts;
  for (const auto& step : steps) texts.push_back(step.label);
  return texts;
}

auto labelled(auto step, std::string label) {
  step.label = std::move(label);
  return step;
}

/// Keeps a step to come back to, with what it costs beside the current one.
void keep(auto step, auto& steps, const auto& now) {
  step.bytes = bytes_beside(step.document, now.document) + bytes_beside(step.components, now.components);
  steps.push_back(std::move(step));
}

void forget_beyond(std::size_t byte_cap, auto& undo, auto& redo) {
  std::size_t bytes = bytes_of(undo) + bytes_of(redo);
  while (bytes > byte_cap && undo.size() + redo.size() > 1) {
    auto& steps = undo.empty() ? redo : undo;
    bytes -= steps.front().bytes;
    steps.pop_front();
  }
}

/// Components that are selected now, in the document as it is.
KeptComponents selected_now(ComponentSelection components, const Document& document, const MeshFinder& find) {
  const KeptComponents now{std::make_shared<const ComponentSelection>(std::move(components)), 0, 0};
  return existing_components(now, document, true, find);
}

}  // namespace

void Versions::set(std::vector<Version> list, bool pictures_alone) {
  const bool stays_saved = pictures_alone && !modified();
  list_ = std::move(list);
  ++state_;
  if (stays_saved) mark_saved();
  changed();
}

std::vector<PastDocument> past_of(const Session& session, std::size_t most) {
  const std::vector<std::string> labels = session.undo_labels();
  const std::vector<Session::State> history = session.history();
  std::vector<PastDocument> past;
  for (std::size_t i = labels.size() - std::min(most, labels.size()); i < labels.size(); ++i) {
    past.push_back({labels[i], history[i].document});
  }
  return past;
}

Session::Session(Document initial, std::size_t byte_cap, MeshFinder find)
    : find_mesh_(std::move(find)), byte_cap_(byte_cap) {
  now_.document = std::move(initial);
  versions.changed = [this] {
    ++revision_;
    report_change();
  };
}

void Session::show(Step step) {
  // Ids that an undone step gave away stay used: code that remembers one must not take a new node for it.
  const NodeId next_id = std::max(now_.document.next_id(), step.document.next_id());
  now_ = std::move(step);
  if (now_.document.next_id() != next_id) now_.document = Document::of(now_.document.nodes(), next_id);
  now_.selection = existing(std::move(now_.selection), now_.document);
  now_.components = existing_components(std::move(now_.components), now_.document, false, find_mesh_);
  ++revision_;
}

void Session::report_change() {
  // By index: a listener may add another.
  for (std::size_t i = 0; i < listeners_.size(); ++i) {
    const auto listener = listeners_[i];
    listener();
  }
}

void Session::edit(std::string label, Document edited, std::optional<ComponentSelection> components) {
  end_drag();
  if (same_content(now_.document, edited)) {
    if (components) select_components(std::move(*components));
    return;
  }
  Step before = labelled(now_, std::move(label));
  show({{}, std::move(edited), now_.selection, now_.components, ++last_state_});
  if (components) now_.components = selected_now(std::move(*components), now_.document, find_mesh_);
  redo_.clear();
  keep(std::move(before), undo_, now_);
  forget_beyond(byte_cap_, undo_, redo_);
  report_change();
}

void Session::begin_drag(std::string label) {
  end_drag();
  drag_ = labelled(now_, std::move(label));
}

void Session::drag(Document edited) {
  if (!drag_) throw Error(make_error(Category::Internal, "E_INTERNAL", "A drag goes on that was never begun."));
  if (edited.nodes() == now_.document.nodes()) return;
  show({{}, std::move(edited), now_.selection, now_.components, ++last_state_});
  report_change();
}

void Session::end_drag() {
  if (!drag_) return;
  Step before = std::move(*drag_);
  drag_.reset();
  if (same_content(before.document, now_.document)) {
    now_.state = before.state;
  } else {
    redo_.clear();
    keep(std::move(before), undo_, now_);
    forget_beyond(byte_cap_, undo_, redo_);
  }
  report_change();
}

void Session::cancel_drag() {
  if (!drag_) return;
  show(*std::exchange(drag_, std::nullopt));
  report_change();
}

void Session::undo() {
  if (end_drag(); can_undo()) go_to(undo_.size() - 1);
}

void Session::redo() { go_to(undo_.size() + 1); }

void Session::go_to(std::size_t steps) {
  end_drag();
  const std::uint64_t before = revision_;
  const auto travel = [this](std::deque<Step>& from, std::deque<Step>& to) {
    Step step = std::move(from.back());
    from.pop_back();
    Step now = labelled(now_, step.label);
    show(std::move(step));
    keep(std::move(now), to, now_);
    forget_beyond(byte_cap_, undo_, redo_);
  };
  while (undo_.size() > steps) travel(undo_, redo_);
  while (undo_.size() < steps && can_redo()) travel(redo_, undo_);
  if (revision_ != before) report_change();
}

std::vector<Session::State> Session::history() const {
  std::vector<State> all;
  for (const Step& step : undo_) all.push_back({step.state, step.document});
  all.push_back({now_.state, now_.document});
  for (auto step = redo_.rbegin(); step != redo_.rend(); ++step) all.push_back({step->state, step->document});
  return all;
}

std::vector<std::string> Session::undo_labels() const { return labels(undo_); }

std::vector<std::string> Session::redo_labels() const {
  std::vector<std::string> texts = labels(redo_);
  std::reverse(texts.begin(), texts.end());
  return texts;
}

std::size_t Session::history_bytes() const { return bytes_of(undo_) + bytes_of(redo_); }

void Session::select(Selection selection) {
  selection = existing(std::move(selection), now_.document);
  if (selection == now_.selection) return;
  now_.selection = std::move(selection);
  ++revision_;
  report_change();
}

void Session::select_components(ComponentSelection components) {
  const auto before = now_.components.selection;
  now_.components = selected_now(std::move(components), now_.document, find_mesh_);
  if (*now_.components.selection == *before) {
    now_.components.selection = before;
    return;
  }
  ++revision_;
  report_change();
}

void Session::check_components() {
  const auto before = now_.components.selection;
  now_.components = existing_components(std::move(now_.components), now_.document, false, find_mesh_);
  if (now_.components.selection == before) return;
  ++revision_;
  report_change();
}

void Session::mark_saved() {
  if (!modified()) return;
  saved_state_ = now_.state;
  versions.mark_saved();
  report_change();
}

void Session::load(Document document, bool modified, std::vector<PastDocument> past, std::vector<Version> kept) {
  drag_.reset();
  undo_.clear();
  redo_.clear();
  now_ = Step();
  now_.document = std::move(document);
  now_.state = ++last_state_;
  saved_state_ = modified ? ++last_state_ : now_.state;
  for (std::size_t i = 0; i < past.size(); ++i) {
    const Document& next = i + 1 < past.size() ? past[i + 1].document : now_.document;
    const std::size_t bytes = bytes_beside(past[i].document, next);
    undo_.push_back({std::move(past[i].label), past[i].document, {}, now_.components, ++last_state_, bytes});
  }
  forget_beyond(byte_cap_, undo_, redo_);
  versions.mark_saved();
  versions.set(std::move(kept), true);
}

void Session::on_change(std::function<void()> listener) { listeners_.push_back(std::move(listener)); }

}  // namespace croquis
