// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/sketch_interaction.h"

#include "croquis/tools/silhouette/stroke_pick.h"

namespace croquis::app {
namespace {

constexpr int pen_watch_ms = 100;
constexpr double mark_reach = 12;  // logical pixels
constexpr double stroke_reach = 8;

}  // namespace

SketchInteraction::SketchInteraction(Studio& studio, const ViewPane& pane, QObject* parent)
    : QObject(parent), studio_(studio), pane_(pane), tool_(studio.session(), studio.tool_options()) {
  connect(&pen_watch_, &QTimer::timeout, this,
          [this] { take_pen(pen_.settle(last_time_ + static_cast<double>(since_event_.nsecsElapsed()) * 1e-9)); });
  set_mode(tool_.mode());
}

void SketchInteraction::set_mode(SketchMode mode) {
  tool_.set_mode(mode);
  PenOptions options = pen_.options();
  options.right_draws = mode == SketchMode::Draw;
  pen_.set_options(options);
  follow_ink();
  scene_.show_hovered(std::nullopt, studio_.drawing());
  scene_.show_drawing(studio_, tool_);
  emit changed();
}

void SketchInteraction::take(const PointerEvent& event) {
  last_time_ = event.time;
  since_event_.start();
  take_pen(pen_.handle(event));
  if (!pen_.down() && event.action != PointerEvent::Action::Leave) hover(event);
}

bool SketchInteraction::abandon() {
  if (!pen_.down()) return false;
  take_pen(pen_.cancel());
  return true;
}

void SketchInteraction::take_pen(const std::vector<PenStep>& steps) {
  const SketchFrame frame = pane_.sketch_frame();
  for (const PenStep& step : steps) feed(to_sketch(step, frame));
  if (!steps.empty()) show_gesture();
  if (pen_.down() && !pen_watch_.isActive()) pen_watch_.start(pen_watch_ms);
  if (!pen_.down()) pen_watch_.stop();
}

void SketchInteraction::feed(const SketchEvent& event) {
  if (tool_.handle(event) == Verdict::Commit && tool_.done()) emit committed(*tool_.done());
}

/// Nothing else changes under the pen: what is computed meanwhile is shown when the stroke has ended.
void SketchInteraction::follow_ink() { studio_.hold_results(inking()); }

void SketchInteraction::show_gesture() {
  follow_ink();
  if (inking()) {
    emit inked();
    return;
  }
  scene_.show_hovered(std::nullopt, studio_.drawing());
  scene_.show_preview(tool_.preview());
  emit changed();
}

QString SketchInteraction::told_at(const Vec2& pixel) const {
  QStringList sentences;
  for (const FindingMark& finding : scene_.finding_marks()) {
    const bool under = (pane_.sketch_frame().to_pixel(finding.at) - pixel).norm() < mark_reach;
    if (under && !sentences.contains(finding.sentence)) sentences << finding.sentence;
  }
  return sentences.join("\n");
}

void SketchInteraction::hover(const PointerEvent& event) {
  told_finding_ = told_at(event.position);
  if (tool_.mode() == SketchMode::Draw) return;
  const SketchFrame frame = pane_.sketch_frame();
  const auto found =
      nearest_stroke(studio_.drawing(), frame.to_sketch(event.position), {stroke_reach, frame.units_per_pixel});
  scene_.show_hovered(found ? std::optional(found->id) : std::nullopt, studio_.drawing());
  emit changed();
}

void SketchInteraction::follow_document() {
  if (!pen_.down()) tool_.set_node(studio_.drawing_node());
  scene_.show_drawing(studio_, tool_);
  scene_.show_preview(tool_.preview());
  emit changed();
}

void SketchInteraction::follow_result() {
  scene_.show_result(studio_);
  scene_.show_drawing(studio_, tool_);
  emit changed();
}

void SketchInteraction::replay_gesture(const std::vector<StrokeSample>& samples, bool erases,
                                       const Modifiers& modifiers, double scale) {
  SketchEvent event;
  event.erases = erases;
  event.modifiers = modifiers;
  event.units_per_pixel = scale > 0 ? scale : pane_.sketch_frame().units_per_pixel;
  event.kind = PenStep::Kind::Begin;
  for (const StrokeSample& sample : samples) {
    event.sample = sample;
    feed(event);
    event.kind = PenStep::Kind::Sample;
  }
  event.kind = PenStep::Kind::End;
  feed(event);
  show_gesture();
}

}  // namespace croquis::app
