// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <cstdint>
#include <optional>

#include "croquis/tools/pointer/pointer_event.h"

class QEventPoint;
class QMouseEvent;
class QTabletEvent;
class QWheelEvent;

namespace croquis::app {

/// When pointer events happened. The window system stamps them; a busy window only takes them late, often many at
/// once, and by that time slow and fast strokes look the same.
class EventClock {
 public:
  /// When an event happened, seconds by the clock of the stamps.
  /// @param stamp milliseconds; 0 for events without: they follow the one before as they are taken
  /// @param now   when it is taken, seconds by a steady clock of this process
  double time_of(std::uint64_t stamp, double now);

  /// How much later the last event was taken than the quickest of those before, seconds.
  double lag() const { return lag_; }

 private:
  double time_ = 0;   ///< of the last event
  double taken_ = 0;  ///< when that was
  double lag_ = 0;
  std::optional<double> quickest_;  ///< least difference of the two clocks
};

/// Qt's events as the tools take them: nothing rounded, nothing left out. Position, view and time are the viewport's to
/// fill in.
PointerEvent pointer_event(const QMouseEvent& event);
PointerEvent pointer_event(const QTabletEvent& event);
PointerEvent pointer_event(const QWheelEvent& event);

/// One finger of a touch event.
PointerEvent pointer_event(const QEventPoint& finger);

/// Where in the widget an event happened.
inline Vec2 to_vec(const QPointF& point) { return {point.x(), point.y()}; }

}  // namespace croquis::app
