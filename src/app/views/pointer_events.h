// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

#include "croquis/tools/pointer/pointer_event.h"

class QMouseEvent;
class QSinglePointEvent;
class QTabletEvent;
class QEventPoint;
class QWheelEvent;

namespace croquis::app {

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
