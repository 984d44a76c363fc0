// SPDX-License-Identifier: GPL-3.0-or-later
// How events of the window reach navigation, pen and tool.
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QToolTip>
#include <QTouchEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "app/pointer_events.h"
#include "app/viewport.h"
#include "croquis/tools/stroke_pick.h"

namespace croquis::app {
namespace {

constexpr double divider_grip = 4;  // logical pixels to either side
constexpr double least_share = 0.15;
constexpr int pen_watch_ms = 100;
constexpr double mark_reach = 12;            // logical pixels
constexpr int twin_key = Qt::Key_QuoteLeft;  // left of 1

}  // namespace

int Viewport::view_at(const QPointF& place) const {
  if (alone_ >= 0) return alone_;
  return place.x() < panes_[PerspectiveView].rect.left() ? SketchView : PerspectiveView;
}

bool Viewport::event(QEvent* event) {
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == twin_key && !key->isAutoRepeat()) navigation_.set_twin_key(event->type() == QEvent::KeyPress);
    navigation_.modifiers_changed(
        {key->modifiers().testFlag(Qt::ShiftModifier), key->modifiers().testFlag(Qt::ControlModifier),
         key->modifiers().testFlag(Qt::AltModifier), key->modifiers().testFlag(Qt::MetaModifier)});
  }
  if (event->type() == QEvent::TouchBegin || event->type() == QEvent::TouchUpdate ||
      event->type() == QEvent::TouchEnd || event->type() == QEvent::TouchCancel) {
    for (const QEventPoint& finger : static_cast<QTouchEvent*>(event)->points()) {
      if (finger.state() != QEventPoint::Stationary) take(pointer_event(finger), finger.position());
    }
    event->accept();  // else Qt makes a mouse event of it, and fingers would draw
    return true;
  }
  return QOpenGLWidget::event(event);
}

void Viewport::note_window_moved() {
  const bool before = navigation_.alt_swallowed();
  navigation_.window_moved();
  if (navigation_.alt_swallowed() != before) emit help_changed();
}

void Viewport::mousePressEvent(QMouseEvent* event) { take(pointer_event(*event), event->position()); }
void Viewport::mouseMoveEvent(QMouseEvent* event) { take(pointer_event(*event), event->position()); }
void Viewport::mouseReleaseEvent(QMouseEvent* event) { take(pointer_event(*event), event->position()); }

void Viewport::tabletEvent(QTabletEvent* event) {
  take(pointer_event(*event), event->position());
  event->accept();  // else Qt makes a mouse event of it
}

void Viewport::wheelEvent(QWheelEvent* event) {
  take(pointer_event(*event), event->position());
  event->accept();
}

void Viewport::leaveEvent(QEvent*) {
  PointerEvent event;
  event.action = PointerEvent::Action::Leave;
  take(event, QPointF(-1, -1));
}

void Viewport::take(PointerEvent event, const QPointF& place) {
  event.time = static_cast<double>(clock_.nsecsElapsed()) * 1e-9;
  if (input_time_ms_ < 0) input_time_ms_ = event.time * 1e3;
  const bool leaving = event.action == PointerEvent::Action::Leave;
  if (drag_divider(event, place)) return;
  if (!leaving) under_pointer_ = view_at(place);
  // A gesture belongs to the view that it began in.
  event.view = grabbed_ >= 0 ? grabbed_ : under_pointer_;
  const ViewPane& pane = panes_[static_cast<std::size_t>(event.view)];
  event.position = to_vec(place - pane.rect.topLeft());
  if (event.buttons.any())
    grabbed_ = event.view;
  else if (!pen_.down())
    grabbed_ = -1;

  PointerEvent for_navigation = event;
  // There is nothing to draw on in the perspective view: plain drags turn it.
  if (event.view == PerspectiveView) for_navigation.modifiers.super = true;
  const Navigation::Answer answer = navigation_.handle(for_navigation);
  for (const auto& motion : {answer.motion, answer.second}) {
    if (!motion) continue;
    panes_[static_cast<std::size_t>(motion->view)].move(*motion);
    turned_ = turned_ || motion->view == PerspectiveView;
    redraw(static_cast<View>(motion->view));
  }
  if (answer.taken || event.view != SketchView) return;
  take_pen(pen_.handle(event));
  if (!pen_.down() && !leaving) hover(event);
}

void Viewport::take_pen(const std::vector<PenStep>& steps) {
  const SketchFrame frame = panes_[SketchView].sketch_frame();
  for (const PenStep& step : steps) feed(to_sketch(step, frame));
  if (!steps.empty()) show_gesture();
  if (pen_.down() && !pen_watch_.isActive()) pen_watch_.start(pen_watch_ms);
  if (!pen_.down()) pen_watch_.stop();
}

void Viewport::feed(const SketchEvent& event) {
  if (tool_.handle(event) == Verdict::Commit && tool_.done()) emit committed(*tool_.done());
}

void Viewport::show_gesture() {
  scenes_.show_hovered(std::nullopt, studio_.drawing());
  scenes_.show_preview(tool_.preview(), studio_.drawing());
  redraw(SketchView);
}

void Viewport::watch_pen() { take_pen(pen_.settle(static_cast<double>(clock_.nsecsElapsed()) * 1e-9)); }

void Viewport::hover(const PointerEvent& event) {
  tell_finding(event);
  if (tool_.mode() == SketchMode::Draw) return;
  const SketchFrame frame = panes_[SketchView].sketch_frame();
  const auto found = nearest_stroke(studio_.drawing(), frame.to_sketch(event.position), {8, frame.units_per_pixel});
  scenes_.show_hovered(found ? std::optional(found->id) : std::nullopt, studio_.drawing());
  redraw(SketchView);
}

void Viewport::tell_finding(const PointerEvent& event) {
  const ViewPane& pane = panes_[SketchView];
  QString sentence;
  for (const FindingMark& finding : scenes_.finding_marks()) {
    const bool under = (pane.sketch_frame().to_pixel(finding.at) - event.position).norm() < mark_reach;
    if (under) sentence = QString::fromStdString(finding.sentence);
  }
  const QPointF place = pane.rect.topLeft() + QPointF(event.position.x(), event.position.y());
  if (!sentence.isEmpty())
    QToolTip::showText(mapToGlobal(place).toPoint(), sentence, this);
  else if (told_finding_)
    QToolTip::hideText();
  told_finding_ = !sentence.isEmpty();
}

bool Viewport::drag_divider(const PointerEvent& event, const QPointF& place) {
  const double edge = panes_[PerspectiveView].rect.left();
  const bool at_edge = alone_ < 0 && std::abs(place.x() - edge) <= divider_grip;
  if (event.action == PointerEvent::Action::Press && at_edge && !pen_.down()) dragging_divider_ = true;
  if (!dragging_divider_) {
    if (event.action == PointerEvent::Action::Hover) {
      setCursor(at_edge ? Qt::SplitHCursor : tool_.mode() == SketchMode::Select ? Qt::ArrowCursor : Qt::CrossCursor);
    }
    return false;
  }
  divider_ = std::clamp(place.x() / width(), least_share, 1 - least_share);
  lay_out();
  redraw_all();
  if (event.action == PointerEvent::Action::Release) dragging_divider_ = false;
  return true;
}

void Viewport::replay_gesture(const std::vector<StrokeSample>& samples, bool erases, const Modifiers& modifiers,
                              double scale) {
  SketchEvent event;
  event.erases = erases;
  event.modifiers = modifiers;
  event.units_per_pixel = scale > 0 ? scale : panes_[SketchView].sketch_frame().units_per_pixel;
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
