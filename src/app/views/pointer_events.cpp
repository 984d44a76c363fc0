// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/pointer_events.h"

#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWheelEvent>
#include <algorithm>

namespace croquis::app {
namespace {

/// No window is this late: the stamps' clock was reset (X servers count 49 days).
constexpr double clock_jump_seconds = 60;

/// By which the least difference is forgotten with every event: two clocks never run exactly alike.
constexpr double drift_seconds = 1e-5;

constexpr double units_per_notch = 120;  // Qt's eighths of a degree
constexpr double radians = 3.14159265358979 / 180;

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

}  // namespace croquis::app
