// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/tool.h"

#include "app/views/viewport.h"
#include "croquis/workspace/chain.h"

namespace croquis::app {
namespace {

constexpr int watch_ms = 100;

}  // namespace

WatchedPen::WatchedPen(Feed feed) : feed_(std::move(feed)) {
  QObject::connect(&watch_, &QTimer::timeout, &watch_, [this] {
    take(input_.settle(last_time_ + static_cast<double>(since_event_.nsecsElapsed()) * 1e-9));
  });
}

void WatchedPen::handle(const PointerEvent& event) {
  last_time_ = event.time;
  since_event_.start();
  take(input_.handle(event));
}

void WatchedPen::take(const std::vector<PenStep>& steps) {
  if (!steps.empty()) feed_(steps);
  if (down() && !watch_.isActive()) watch_.start(watch_ms);
  if (!down()) watch_.stop();
}

Tool::Tool(ToolHost& host, const QString& about)
    : help_topic(about), pen_([this](const std::vector<PenStep>& steps) { feed(steps); }), host_(host) {}

void Tool::take(const PointerEvent& event) {
  const bool leaves = event.action == PointerEvent::Action::Leave;
  if (!leaves || !drags_leave_views_) pen_.handle(event);
  if (!pen_.down() || leaves) hover(event);
}

bool Tool::abandon() {
  if (!pen_.down()) return false;
  pen_.cancel();
  return true;
}

bool works_on(const Studio& studio, const Node& step, ValueType type) {
  const OperationDescription* operation = studio.description(step.operation);
  const PortDescription* input = operation == nullptr ? nullptr : main_input(*operation);
  return (step.source && step.source->type() == type) || (input != nullptr && input->type == type);
}

void show_sketch_view(Viewport& views) {
  if (!views.pane(SketchView).visible()) views.arrange(Arrangement::SketchAndSolid);
}

std::optional<SelectionFrame> frame_around(render::Bounds selected, const glm::dvec3& around) {
  if (selected.empty()) return std::nullopt;
  const glm::dvec3 middle = selected.center();
  selected.add(middle - around / 2.0);
  selected.add(middle + around / 2.0);
  return SelectionFrame{selected, std::nullopt, true};
}

QString sentences_of(const Findings& findings) {
  QStringList sentences;
  for (const Finding& finding : findings) {
    const QString sentence = QString::fromStdString(finding.message);
    sentences << (sentence.endsWith('.') ? sentence : sentence + ".");
  }
  return sentences.join(' ');
}

}  // namespace croquis::app
