// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/pointer_events.h"

#include <QAction>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QToolTip>
#include <QTouchEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace croquis::app {
namespace {

/// No window is this late: the stamps' clock was reset (X servers count 49 days).
constexpr double clock_jump_seconds = 60;

/// By which the least difference is forgotten with every event: two clocks never run exactly alike.
constexpr double drift_seconds = 1e-5;

constexpr double units_per_notch = 120;  // Qt's eighths of a degree
constexpr double radians = 3.14159265358979 / 180;

constexpr int long_press_ms = 400;
constexpr double long_press_reach = 6;       // logical pixels: a pen that moves further draws
constexpr int twin_key = Qt::Key_QuoteLeft;  // left of 1
constexpr double late_seconds = 0.03;        // a move that is handled later than that has waited for a busy window

Modifiers modifiers_of(Qt::KeyboardModifiers keys) {
  return {keys.testFlag(Qt::ShiftModifier), keys.testFlag(Qt::ControlModifier), keys.testFlag(Qt::AltModifier),
          keys.testFlag(Qt::MetaModifier)};
}

PointerEvent::Action action_of(QEvent::Type type, bool held) {
  switch (type) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::TabletPress: return PointerEvent::Action::Press;
    case QEvent::MouseButtonRelease:
    case QEvent::TabletRelease: return PointerEvent::Action::Release;
    default: return held ? PointerEvent::Action::Move : PointerEvent::Action::Hover;
  }
}

bool is_modifier(int key) {
  const bool plain = key >= Qt::Key_Shift && key <= Qt::Key_ScrollLock;
  return plain || key == Qt::Key_AltGr || key == Qt::Key_Super_L || key == Qt::Key_Super_R;
}

/// The note about Alt goes once something else is done.
void forget_swallowed_alt(Views& views) {
  if (!views.navigation.alt_swallowed()) return;
  views.navigation.something_done();
  emit views.help_changed();
}

/// The actions around the pointer in a view; none without a marking menu.
QStringList menu_in(const Views& views, int view) {
  const Tool* tool = tool_in(views, view);
  return tool == nullptr ? QStringList() : tool->use_of(view).menu;
}

void open_marking_menu(PointerInput& input, const QPointF& place) {
  const QStringList sectors = menu_in(input.views, input.views.under_pointer);
  for (std::size_t i = 0; i < MarkingMenu::places; ++i) {
    const QString name = sectors.value(static_cast<int>(i));
    input.menu.set_action(i, name.isEmpty() ? nullptr : input.views.widget.window()->findChild<QAction*>(name));
  }
  input.menu.open(place);
}

/// Held, the key opens the marking menu at the pointer; let go, it chooses: for pens that only hover.
bool take_marking_key(PointerInput& input, const QKeyEvent& event) {
  if (input.menu_by_key && event.type() == QEvent::KeyRelease) {
    if (event.isAutoRepeat()) return true;
    input.menu_by_key = false;
    input.menu.choose();
    return true;
  }
  const Views& views = input.views;
  const Tool* tool = event.modifiers() == Qt::NoModifier ? tool_in(views, views.under_pointer) : nullptr;
  const bool goes_down = event.type() != QEvent::KeyRelease;
  if (!goes_down || tool == nullptr || tool->keys.marking_menu != event.key() || any_down(views)) return false;
  if (event.type() == QEvent::KeyPress && !event.isAutoRepeat() && !input.menu.is_open()) {
    open_marking_menu(input, input.place);
    input.menu_by_key = true;
  }
  return true;
}

/// Keys that mean something on what is under the pointer aren't menu shortcuts there.
bool take_tool_key(const Views& views, const QKeyEvent& event) {
  if (event.type() == QEvent::KeyRelease || event.modifiers() != Qt::NoModifier) return false;
  Tool* tool = tool_in(views, views.under_pointer);
  // While one draws, the sheet's keys mean the same wherever the pointer rests.
  const bool is_taken = tool != nullptr && tool->keys.pressed.contains(event.key());
  if (!is_taken && views.mode == first_mode && views.layout.pane(SketchView).visible())
    tool = tool_in(views, SketchView);
  if (tool == nullptr || !tool->keys.pressed.contains(event.key())) return false;
  if (event.type() == QEvent::KeyPress && !event.isAutoRepeat()) tool->keys.pressed.at(event.key())();
  return true;
}

bool take_key(PointerInput& input, QKeyEvent& event) {
  Views& views = input.views;
  if (take_marking_key(input, event) || take_tool_key(views, event)) {
    event.accept();
    return true;
  }
  if (event.type() == QEvent::ShortcutOverride) {
    // Shortcuts send no other event.
    if (!is_modifier(event.key())) forget_swallowed_alt(views);
    return false;
  }
  const bool is_press = event.type() == QEvent::KeyPress;
  if (event.key() == twin_key && !event.isAutoRepeat()) views.navigation.set_twin_key(is_press);
  const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
  Tool* tool = enter && is_press ? tool_in(views, views.under_pointer) : nullptr;
  if (tool != nullptr) tool->command(EditCommand::Accept);
  views.navigation.modifiers_changed(modifiers_of(event.modifiers()));
  return false;
}

bool take_marking(PointerInput& input, const PointerEvent& event, const QPointF& place) {
  using Action = PointerEvent::Action;
  // The side switch with the tip down pans.
  if (input.menu.is_open() && event.buttons.barrel && event.buttons.left) input.menu.dismiss();
  if (input.menu.is_open()) {
    input.menu.move_to(place);
    const bool let_go = !input.menu_by_key && !event.buttons.any() &&
                        (event.action == Action::Release || event.action == Action::Hover);
    if (let_go) {
      input.grabbed = -1;
      input.menu.choose();
    }
    return true;
  }
  const bool has_menu = !menu_in(input.views, event.view).isEmpty();
  const bool alone = !event.modifiers.alt && !event.modifiers.super;
  const bool by_mouse = event.device == PointerEvent::Device::Mouse && event.buttons.right;
  const bool by_pen = is_pen(event.device) && event.buttons.barrel && input.views.layout.pane(event.view).flat() &&
                      !event.modifiers.shift && !event.modifiers.ctrl;
  if (has_menu && alone && event.action == Action::Press && (by_mouse || by_pen) && !event.buttons.left) {
    open_marking_menu(input, place);
    return true;
  }
  if (has_menu && is_pen(event.device) && event.action == Action::Press && event.buttons.left) {
    input.pressed_at = place;
    input.long_press.start();
  }
  const QPointF way = place - input.pressed_at;
  if (event.action == Action::Release || std::hypot(way.x(), way.y()) > long_press_reach) input.long_press.stop();
  return false;
}

bool drag_border(PointerInput& input, const PointerEvent& event, const QPointF& place) {
  Views& views = input.views;
  const PaneLayout::Border under = views.layout.border_at(place);
  if (event.action == PointerEvent::Action::Press && under.any() && !any_down(views)) input.border = under;
  if (!input.border.any()) {
    if (event.action == PointerEvent::Action::Hover) {
      if (under.any())
        views.widget.setCursor(under.across && under.down ? Qt::SizeAllCursor
                               : under.across             ? Qt::SplitHCursor
                                                          : Qt::SplitVCursor);
      else
        show_cursor(views, views.layout.view_at(place));
    }
    return false;
  }
  views.layout.drag_border(input.border, place);
  views.clear = true;
  emit views.changed();
  if (event.action == PointerEvent::Action::Release) input.border = {};
  return true;
}

/// @return whether nothing else may see the event
bool navigate(Views& views, PointerEvent event) {
  // Where there is nothing to pick and nothing to draw on, plain drags rotate the view.
  if (tool_in(views, event.view) == nullptr) event.modifiers.super = true;
  const Navigation::Answer answer = views.navigation.handle(event);
  for (const auto& motion : {answer.motion, answer.second}) {
    if (motion) move_view(views, *motion);
  }
  return answer.taken;
}

/// About what is under the pointer, until it leaves that.
void show_tooltip(PointerInput& input, const QString& sentence, const QPointF& place) {
  QWidget& widget = input.views.widget;
  if (!sentence.isEmpty())
    QToolTip::showText(widget.mapToGlobal(place).toPoint(), sentence, &widget);
  else if (input.shows_tooltip)
    QToolTip::hideText();
  input.shows_tooltip = !sentence.isEmpty();
}

double seconds(const PointerInput& input) { return static_cast<double>(input.clock.nsecsElapsed()) * 1e-9; }

void take_in_time(PointerInput& input, PointerEvent event, const QPointF& place) {
  Views& views = input.views;
  if (input.waiting_since_ms < 0) input.waiting_since_ms = seconds(input) * 1e3;
  if (event.action == PointerEvent::Action::Press || event.action == PointerEvent::Action::Wheel)
    forget_swallowed_alt(views);
  const bool leaving = event.action == PointerEvent::Action::Leave;
  if (drag_border(input, event, place)) return;
  if (!leaving) {
    views.under_pointer = views.layout.view_at(place);
    input.place = place;
  }
  // A gesture belongs to the view that it began in.
  event.view = input.grabbed >= 0 ? input.grabbed : views.under_pointer;
  const QPointF in_view = place - views.layout.pane(event.view).rect.topLeft();
  event.position = {in_view.x(), in_view.y()};
  if (take_marking(input, event, place)) return;
  if (event.buttons.any()) input.grabbed = event.view;
  Tool* tool = navigate(views, event) ? nullptr : tool_in(views, event.view);
  if (tool != nullptr) tool->take(event);
  if (!event.buttons.any() && !any_down(views)) input.grabbed = -1;
  if (!any_down(views) && !leaving) show_tooltip(input, tool == nullptr ? QString() : tool->words().tooltip, place);
}

void take_late_move(PointerInput& input) {
  if (const auto move = std::exchange(input.late_move, std::nullopt)) take_in_time(input, move->event, move->place);
}

/// Ink takes every move of the mouse. For all else the newest is enough, and where moves have waited for a busy window,
/// only that one is worth the work.
void take_pointer(PointerInput& input, PointerEvent event, const QPointF& place, std::uint64_t stamp) {
  event.time = input.event_clock.time_of(stamp, seconds(input));
  const bool moves = event.action == PointerEvent::Action::Move || event.action == PointerEvent::Action::Hover;
  const int view = input.grabbed >= 0 ? input.grabbed : input.views.under_pointer;
  const Tool* tool = tool_in(input.views, view);
  const bool draws = event.buttons.any() && tool != nullptr && tool->use_of(view).every_move;
  if (event.device == PointerEvent::Device::Mouse && moves && !draws && input.event_clock.lag() > late_seconds) {
    const bool same_hand = input.late_move && input.late_move->event.buttons == event.buttons;
    if (!same_hand) {
      take_late_move(input);
      const auto take_later = [&input] { take_late_move(input); };
      QMetaObject::invokeMethod(&input.menu, take_later, Qt::QueuedConnection);
    }
    input.late_move = {event, place};
    return;
  }
  take_late_move(input);
  take_in_time(input, event, place);
}

template <typename Event>
bool take_from_device(PointerInput& input, QEvent& event) {
  auto& sent = static_cast<Event&>(event);
  take_pointer(input, pointer_event(sent), sent.position(), sent.timestamp());
  event.accept();  // else Qt makes a mouse event of a pen's
  return true;
}

/// Buttons lie over the views: what a pen does on them comes here first.
bool is_for_button(PointerInput& input, const QTabletEvent& event) {
  const bool is_over_one = input.grabbed < 0 && input.views.widget.childAt(event.position().toPoint()) != nullptr;
  if (event.type() == QEvent::TabletRelease) return std::exchange(input.pen_on_button, false);
  if (event.type() == QEvent::TabletPress) return input.pen_on_button = is_over_one;
  return event.buttons() == Qt::NoButton ? is_over_one : input.pen_on_button;
}

}  // namespace

double EventClock::time_of(std::uint64_t stamp, double now) {
  if (stamp == 0) {
    time_ += now - taken_;
    lag_ = 0;
  } else {
    time_ = static_cast<double>(stamp) * 1e-3;
    const double difference = now - time_;
    if (!quickest_ || difference - *quickest_ > clock_jump_seconds) quickest_ = difference;
    quickest_ = std::min(*quickest_ + drift_seconds, difference);
    lag_ = difference - *quickest_;
  }
  taken_ = now;
  return time_;
}

PointerEvent pointer_event(const QMouseEvent& event) {
  PointerEvent result;
  result.device = PointerEvent::Device::Mouse;
  result.buttons = {event.buttons().testFlag(Qt::LeftButton), event.buttons().testFlag(Qt::MiddleButton),
                    event.buttons().testFlag(Qt::RightButton), false};
  result.action = action_of(event.type(), result.buttons.any());
  result.modifiers = modifiers_of(event.modifiers());
  return result;
}

PointerEvent pointer_event(const QTabletEvent& event) {
  PointerEvent result;
  const bool eraser = event.pointerType() == QPointingDevice::PointerType::Eraser;
  result.device = eraser ? PointerEvent::Device::Eraser : PointerEvent::Device::Pen;
  // Of a pen the middle and right buttons are its side switches.
  result.buttons = {event.buttons().testFlag(Qt::LeftButton), false, false,
                    event.buttons().testFlag(Qt::RightButton) || event.buttons().testFlag(Qt::MiddleButton)};
  result.action = action_of(event.type(), result.buttons.any());
  result.pressure = event.pressure();
  result.tilt = radians * Vec2(event.xTilt(), event.yTilt());
  result.modifiers = modifiers_of(event.modifiers());
  result.device_id = static_cast<std::uint64_t>(event.pointingDevice()->uniqueId().numericId());
  return result;
}

PointerEvent pointer_event(const QWheelEvent& event) {
  PointerEvent result;
  result.action = PointerEvent::Action::Wheel;
  result.wheel = event.angleDelta().y() / units_per_notch;
  // With Alt held, the wheel turns sideways.
  if (result.wheel == 0) result.wheel = event.angleDelta().x() / units_per_notch;
  result.modifiers = modifiers_of(event.modifiers());
  return result;
}

PointerEvent pointer_event(const QEventPoint& finger) {
  PointerEvent result;
  result.device = PointerEvent::Device::Touch;
  result.device_id = static_cast<std::uint64_t>(finger.id());
  result.buttons.left = finger.state() != QEventPoint::Released;
  result.action = finger.state() == QEventPoint::Pressed    ? PointerEvent::Action::Press
                  : finger.state() == QEventPoint::Released ? PointerEvent::Action::Release
                                                            : PointerEvent::Action::Move;
  return result;
}

PointerInput::PointerInput(Views& shown) : views(shown), menu(&shown.widget) {
  clock.start();
  long_press.setSingleShot(true);
  long_press.setInterval(long_press_ms);
  QObject::connect(&long_press, &QTimer::timeout, &long_press, [this] {
    if (abandon(views)) open_marking_menu(*this, pressed_at);
  });
}

bool take(PointerInput& input, QEvent& event) {
  switch (event.type()) {
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
    case QEvent::KeyRelease: return take_key(input, static_cast<QKeyEvent&>(event));
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease: return take_from_device<QMouseEvent>(input, event);
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
      if (!is_for_button(input, static_cast<QTabletEvent&>(event))) return take_from_device<QTabletEvent>(input, event);
      event.ignore();  // Qt makes a mouse event of it, which the button understands
      return true;
    case QEvent::Wheel: return take_from_device<QWheelEvent>(input, event);
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
      for (const QEventPoint& finger : static_cast<QTouchEvent&>(event).points()) {
        if (finger.state() == QEventPoint::Stationary) continue;
        take_pointer(input, pointer_event(finger), finger.position(), static_cast<QTouchEvent&>(event).timestamp());
      }
      event.accept();  // else Qt makes a mouse event of it, and fingers would draw
      return true;
    case QEvent::Leave: {
      PointerEvent left;
      left.action = PointerEvent::Action::Leave;
      take_pointer(input, left, QPointF(-1, -1), 0);
      return false;
    }
    default: return false;
  }
}

void note_window_moved(Views& views) {
  const bool before = views.navigation.alt_swallowed();
  views.navigation.window_moved();
  if (views.navigation.alt_swallowed() != before) emit views.help_changed();
}

}  // namespace croquis::app
