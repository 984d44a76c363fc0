// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "croquis/geometry/vector.h"

namespace croquis {

/// What an event or a command led to.
enum class Verdict {
  Continue,  ///< go on: only the preview may have changed
  Commit,    ///< something was done: see the tool's done()
  Revert     ///< what had begun was given up
};

/// Keys that change what a button does. `super` is also set while the Alt-free twin key is held (see Navigation).
struct Modifiers {
  bool shift = false;
  bool ctrl = false;
  bool alt = false;
  bool super = false;

  friend bool operator==(const Modifiers&, const Modifiers&) = default;
};

/// What is held down AFTER the event: a Press includes the new button, a Release no longer has the one let go.
struct Buttons {
  bool left = false;  ///< of a pen: its tip (or the tip of its eraser end) touches
  bool middle = false;
  bool right = false;
  bool barrel = false;  ///< of a pen: the switch on its side

  bool any() const { return left || middle || right || barrel; }
  friend bool operator==(const Buttons&, const Buttons&) = default;
};

/// One raw event of a mouse, tablet or finger, as a window got it: nothing left out, merged or made up. It belongs to
/// no window system, so a recorded trace replays in a test.
struct PointerEvent {
  enum class Device { Mouse, Pen, Eraser, Touch };
  enum class Action {
    Press,
    Move,  ///< with something held down
    Release,
    Hover,  ///< moved with nothing held down
    Leave,  ///< left the view; Mouse where the device isn't known
    ProximityIn,
    ProximityOut,
    Wheel
  };

  Device device = Device::Mouse;
  Action action = Action::Hover;
  Vec2 position = Vec2::Zero();  ///< logical pixels of the view, never rounded, y DOWN
  double pressure = 0;           ///< 0..1; 0 when the device doesn't report it (yet)
  Vec2 tilt = Vec2::Zero();      ///< radians from the surface's normal towards x and y
  double time = 0;               ///< seconds by any clock that all events share
  Buttons buttons;
  Modifiers modifiers;
  int view = 0;                 ///< which of the window's views
  std::uint64_t device_id = 0;  ///< distinguishes pens; of Touch: the finger
  double wheel = 0;             ///< notches of a Wheel, away from the user positive; fractions are fine
};

/// The two ends of a pen count as one device here: drivers confuse them in flight.
inline bool is_pen(PointerEvent::Device device) {
  return device == PointerEvent::Device::Pen || device == PointerEvent::Device::Eraser;
}

}  // namespace croquis
