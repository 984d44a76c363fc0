// SPDX-License-Identifier: GPL-3.0-or-later
// How events of the window reach navigation and the tools, and what the help line shows about them.
#include <QAction>
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QToolTip>
#include <QTouchEvent>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "app/views/pointer_events.h"
#include "app/views/viewport.h"

namespace croquis::app {
namespace {

constexpr double long_press_reach = 6;       // logical pixels: a pen that moves further draws
constexpr int twin_key = Qt::Key_QuoteLeft;  // left of 1
constexpr double late_seconds = 0.03;        // a move that is handled later than that has waited for a busy window

bool is_modifier(int key) {
  const bool plain = key >= Qt::Key_Shift && key <= Qt::Key_ScrollLock;
  return plain || key == Qt::Key_AltGr || key == Qt::Key_Super_L || key == Qt::Key_Super_R;
}

}  // namespace

/// Keys that mean something on what is under the pointer aren't menu shortcuts there.
bool Viewport::take_key(QKeyEvent& event) {
  Tool* tool = event.modifiers() == Qt::NoModifier ? tool_in(under_pointer_) : nullptr;
  // While one draws, the sheet's keys mean the same wherever the pointer rests.
  const bool is_taken = tool != nullptr && tool->keys.pressed.contains(event.key());
  if (!is_taken && event.modifiers() == Qt::NoModifier && mode_ == first_mode && layout_.pane(SketchView).visible())
    tool = tool_in(SketchView);
  if (tool == nullptr || !tool->keys.pressed.contains(event.key())) return false;
  if (event.type() == QEvent::KeyPress && !event.isAutoRepeat()) tool->keys.pressed.at(event.key())();
  event.accept();
  return true;
}

/// Held, the key opens the marking menu at the pointer; let go, it chooses: for pens that only hover.
bool Viewport::take_marking_key(const QKeyEvent& event) {
  if (marking_by_key_ && event.type() == QEvent::KeyRelease) {
    if (event.isAutoRepeat()) return true;
    marking_by_key_ = false;
    marking_menu_.choose();
    return true;
  }
  const Tool* tool = event.modifiers() == Qt::NoModifier ? tool_in(under_pointer_) : nullptr;
  const bool goes_down = event.type() == QEvent::ShortcutOverride || event.type() == QEvent::KeyPress;
  if (!goes_down || tool == nullptr || tool->keys.marking_menu != event.key() || any_down()) return false;
  if (event.type() == QEvent::KeyPress && !event.isAutoRepeat() && !marking_menu_.is_open()) {
    open_marking_menu(pointer_at_);
    marking_by_key_ = true;
  }
  return true;
}

bool Viewport::event(QEvent* event) {
  const bool is_key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress ||
                      event->type() == QEvent::KeyRelease;
  if (is_key && take_marking_key(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  const bool key_goes_down = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (key_goes_down && take_key(*static_cast<QKeyEvent*>(event))) return true;
  // Shortcuts send no other event.
  if (event->type() == QEvent::ShortcutOverride && !is_modifier(static_cast<QKeyEvent*>(event)->key())) {
    forget_swallowed_alt();
  }
  if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == twin_key && !key->isAutoRepeat()) navigation_.set_twin_key(event->type() == QEvent::KeyPress);
    const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    if (enter && event->type() == QEvent::KeyPress) {
      if (Tool* tool = tool_in(under_pointer_)) tool->command(EditCommand::Accept);
    }
    navigation_.modifiers_changed(
        {key->modifiers().testFlag(Qt::ShiftModifier), key->modifiers().testFlag(Qt::ControlModifier),
         key->modifiers().testFlag(Qt::AltModifier), key->modifiers().testFlag(Qt::MetaModifier)});
  }
  if (event->type() == QEvent::TouchBegin || event->type() == QEvent::TouchUpdate ||
      event->type() == QEvent::TouchEnd || event->type() == QEvent::TouchCancel) {
    for (const QEventPoint& finger : static_cast<QTouchEvent*>(event)->points()) {
      if (finger.state() == QEventPoint::Stationary) continue;
      take(pointer_event(finger), finger.position(), static_cast<QTouchEvent*>(event)->timestamp());
    }
    event->accept();  // else Qt makes a mouse event of it, and fingers would draw
    return true;
  }
  return QOpenGLWidget::event(event);
}

/// The note about Alt goes once something else is done.
void Viewport::forget_swallowed_alt() {
  if (!navigation_.alt_swallowed()) return;
  navigation_.something_done();
  emit help_changed();
}

void Viewport::note_window_moved() {
  const bool before = navigation_.alt_swallowed();
  navigation_.window_moved();
  if (navigation_.alt_swallowed() != before) emit help_changed();
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  take(pointer_event(*event), event->position(), event->timestamp());
}
void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  take(pointer_event(*event), event->position(), event->timestamp());
}
void Viewport::mouseMoveEvent(QMouseEvent* event) {
  take(pointer_event(*event), event->position(), event->timestamp());
}
void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  take(pointer_event(*event), event->position(), event->timestamp());
}

void Viewport::tabletEvent(QTabletEvent* event) {
  take(pointer_event(*event), event->position(), event->timestamp());
  event->accept();  // else Qt makes a mouse event of it
}

void Viewport::wheelEvent(QWheelEvent* event) {
  take(pointer_event(*event), event->position(), event->timestamp());
  event->accept();
}

void Viewport::leaveEvent(QEvent*) {
  PointerEvent event;
  event.action = PointerEvent::Action::Leave;
  take(event, QPointF(-1, -1), 0);
}

/// Ink takes every move of the mouse. For all else the newest is enough, and where moves have waited for a busy window,
/// only that one is worth the work.
void Viewport::take(const PointerEvent& event, const QPointF& place, std::uint64_t stamp) {
  PointerEvent timed = event;
  timed.time = event_clock_.time_of(stamp, seconds());
  const bool moves = event.action == PointerEvent::Action::Move || event.action == PointerEvent::Action::Hover;
  const int view = grabbed_ >= 0 ? grabbed_ : under_pointer_;
  const Tool* tool = tool_in(view);
  const bool draws = event.buttons.any() && tool != nullptr && tool->use_of(view).every_move;
  if (event.device == PointerEvent::Device::Mouse && moves && !draws && event_clock_.lag() > late_seconds) {
    const bool same_hand = late_move_ && late_move_->event.buttons == event.buttons;
    if (!same_hand) {
      take_late_move();
      QMetaObject::invokeMethod(this, &Viewport::take_late_move, Qt::QueuedConnection);
    }
    late_move_ = {timed, place};
    return;
  }
  take_late_move();
  take_in_time(timed, place);
}

void Viewport::take_late_move() {
  if (const auto move = std::exchange(late_move_, std::nullopt)) take_in_time(move->event, move->place);
}

void Viewport::take_in_time(PointerEvent event, const QPointF& place) {
  if (input_time_ms_ < 0) input_time_ms_ = seconds() * 1e3;
  if (event.action == PointerEvent::Action::Press || event.action == PointerEvent::Action::Wheel)
    forget_swallowed_alt();
  const bool leaving = event.action == PointerEvent::Action::Leave;
  if (drag_border(event, place)) return;
  if (!leaving) {
    under_pointer_ = layout_.view_at(place);
    pointer_at_ = place;
  }
  // A gesture belongs to the view that it began in.
  event.view = grabbed_ >= 0 ? grabbed_ : under_pointer_;
  event.position = to_vec(place - layout_.pane(event.view).rect.topLeft());
  if (take_marking(event, place)) return;
  if (event.buttons.any()) grabbed_ = event.view;
  Tool* tool = navigate(event) ? nullptr : tool_in(event.view);
  if (tool != nullptr) tool->take(event);
  if (!event.buttons.any() && !any_down()) grabbed_ = -1;
  if (!any_down() && !leaving) show_tooltip(tool == nullptr ? QString() : tool->words().tooltip, place);
}

/// About what is under the pointer, until it leaves that.
void Viewport::show_tooltip(const QString& sentence, const QPointF& place) {
  if (!sentence.isEmpty())
    QToolTip::showText(mapToGlobal(place).toPoint(), sentence, this);
  else if (shows_tooltip_)
    QToolTip::hideText();
  shows_tooltip_ = !sentence.isEmpty();
}

void Viewport::move_camera(int view, const CameraMotion& motion) {
  if (view == PerspectiveView) look_through(0);
  layout_.pane(view).move(motion);
}

bool Viewport::navigate(const PointerEvent& event) {
  PointerEvent seen = event;
  // Where there is nothing to pick and nothing to draw on, plain drags rotate the view.
  if (tool_in(event.view) == nullptr) seen.modifiers.super = true;
  const Navigation::Answer answer = navigation_.handle(seen);
  for (const auto& motion : {answer.motion, answer.second}) {
    if (!motion) continue;
    // Compared views have one camera.
    const int view = motion->view == ComparisonView ? PerspectiveView : motion->view;
    move_camera(view, *motion);
    turned_ = turned_ || view == PerspectiveView;
    redraw_moved(view);
    if (view == PerspectiveView) redraw_moved(ComparisonView);
  }
  return answer.taken;
}

void Viewport::open_marking_menu(const QPointF& place) {
  const Tool* tool = tool_in(under_pointer_);
  const QStringList sectors = tool == nullptr ? QStringList() : tool->use_of(under_pointer_).menu;
  for (std::size_t i = 0; i < MarkingMenu::places; ++i) {
    const QString name = sectors.value(static_cast<int>(i));
    marking_menu_.set_action(i, name.isEmpty() ? nullptr : window()->findChild<QAction*>(name));
  }
  marking_menu_.open(place);
}

bool Viewport::take_marking(const PointerEvent& event, const QPointF& place) {
  using Action = PointerEvent::Action;
  // The side switch with the tip down pans.
  if (marking_menu_.is_open() && event.buttons.barrel && event.buttons.left) marking_menu_.dismiss();
  if (marking_menu_.is_open()) {
    marking_menu_.move_to(place);
    const bool let_go =
        !marking_by_key_ && !event.buttons.any() && (event.action == Action::Release || event.action == Action::Hover);
    if (let_go) {
      grabbed_ = -1;
      marking_menu_.choose();
    }
    return true;
  }
  const Tool* tool = tool_in(event.view);
  const QStringList sectors = tool == nullptr ? QStringList() : tool->use_of(event.view).menu;
  const bool alone = !event.modifiers.alt && !event.modifiers.super;
  const bool by_mouse = event.device == PointerEvent::Device::Mouse && event.buttons.right;
  const bool by_pen = is_pen(event.device) && event.buttons.barrel && layout_.pane(event.view).flat() &&
                      !event.modifiers.shift && !event.modifiers.ctrl;
  if (!sectors.isEmpty() && alone && event.action == Action::Press && (by_mouse || by_pen) && !event.buttons.left) {
    open_marking_menu(place);
    return true;
  }
  if (!sectors.isEmpty() && is_pen(event.device) && event.action == Action::Press && event.buttons.left) {
    pressed_at_ = place;
    long_press_.start();
  }
  const QPointF way = place - pressed_at_;
  if (event.action == Action::Release || std::hypot(way.x(), way.y()) > long_press_reach) long_press_.stop();
  return false;
}

void Viewport::show_cursor(int view) {
  const Tool* tool = tool_in(view);
  setCursor(tool == nullptr ? Qt::ArrowCursor : tool->use_of(view).cursor);
}

bool Viewport::drag_border(const PointerEvent& event, const QPointF& place) {
  const PaneLayout::Border under = layout_.border_at(place);
  if (event.action == PointerEvent::Action::Press && under.any() && !any_down()) dragged_border_ = under;
  if (!dragged_border_.any()) {
    if (event.action == PointerEvent::Action::Hover) {
      if (under.any())
        setCursor(under.across && under.down ? Qt::SizeAllCursor : under.across ? Qt::SplitHCursor : Qt::SplitVCursor);
      else
        show_cursor(layout_.view_at(place));
    }
    return false;
  }
  layout_.drag_border(dragged_border_, place);
  clear_ = true;
  redraw_all();
  if (event.action == PointerEvent::Action::Release) dragged_border_ = {};
  return true;
}

QString Viewport::help_topic() const {
  const Tool* tool = tool_in(under_pointer_);
  return tool == nullptr ? QString() : tool->help_topic;
}

QString Viewport::help() const {
  for (const NodeFinding& found : ink() ? std::vector<NodeFinding>() : findings_of(studio_)) {
    if (found.finding.severity == Severity::Error) return QString::fromStdString(found.finding.message);
  }
  if (navigation_.alt_swallowed()) {
    return tr("Your desktop uses Alt: hold Super, or the key left of 1, and drag to rotate, pan and zoom");
  }
  if (const Tool* tool = tool_in(under_pointer_)) return tool->words().help;
  const Tool* elsewhere = nullptr;
  for (const int view : layout_.shown()) {
    if (elsewhere == nullptr) elsewhere = tool_in(view);
  }
  return elsewhere == nullptr ? QString() : elsewhere->words().help;
}

}  // namespace croquis::app
