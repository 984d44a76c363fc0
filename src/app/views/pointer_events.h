// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QPointF>
#include <QTimer>
#include <cstdint>
#include <optional>

#include "app/views/marking_menu.h"
#include "app/views/views.h"
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

/// Pen, mouse, touch, wheel and keys over the views: what is under way with them.
struct PointerInput {
  explicit PointerInput(Views& shown);

  struct LateMove {
    PointerEvent event;
    QPointF place;
  };

  Views& views;
  MarkingMenu menu;
  bool menu_by_key = false;  ///< it is open while a key is held, and follows the pointer
  QPointF place;             ///< of the pointer, logical pixels of the widget
  QPointF pressed_at;
  QTimer long_press;          ///< a pen that rests opens the marking menu
  int grabbed = -1;           ///< the view that the gesture under way began in, or -1
  PaneLayout::Border border;  ///< being dragged
  bool shows_tooltip = false;
  bool pen_on_button = false;  ///< the pen has pressed one of the buttons over the views
  QElapsedTimer clock;
  EventClock event_clock;
  std::optional<LateMove> late_move;  ///< a newer one may make it needless
  double waiting_since_ms = -1;       ///< by the clock: the oldest input that no frame has shown yet; -1: none
};

/// Passes an event of the widget to navigation, the borders between the views, the marking menu or the tool that works
/// in the view. @return whether nobody else may have it
bool take(PointerInput& input, QEvent& event);

/// The window itself was moved: by Alt and a drag, the desktop may keep them for itself.
void note_window_moved(Views& views);

}  // namespace croquis::app
