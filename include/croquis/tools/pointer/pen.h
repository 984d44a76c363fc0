// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "croquis/tools/pointer/pointer_event.h"

namespace croquis {

/// One clean point of a stroke, as the device gave it.
struct PenSample {
  Vec2 position = Vec2::Zero();  ///< logical pixels of the view, y down
  double pressure = 1;           ///< 0..1; 1 for devices without
  Vec2 tilt = Vec2::Zero();      ///< radians
  double time = 0;               ///< the event's own
};

/// What became of an event. Strokes arrive as Begin, any number of Sample, then End or Cancel, never interleaved.
struct PenStep {
  enum class Kind {
    Begin,   ///< `sample` is the first point
    Sample,  ///< `sample` is the next point
    End,     ///< the stroke is done; `sample` repeats its last point
    Cancel   ///< the stroke was none: forget it
  };

  Kind kind = Kind::Begin;
  PenSample sample;
  PointerEvent::Device device = PointerEvent::Device::Mouse;  ///< the owner
  bool erases = false;                                        ///< drawn with the eraser end
  bool right = false;                                         ///< drawn with the right button of a mouse
  int view = 0;                                               ///< where the stroke began
  Modifiers modifiers;                                        ///< as they were at the beginning
};

struct PenOptions {
  bool eraser_erases = true;  ///< false: the eraser end draws, for tablets that report it falsely
  bool right_draws = false;   ///< strokes are drawn with the right button of a mouse as well
  double twin_seconds = 0.2;  ///< mouse events this near in time to the pen's may be the driver's copies of them …
  double twin_pixels = 24;    ///< … when they are this near to where the pen has been; copies are rounded and late
  double rebound_seconds = 0.02;   ///< contact without a press this soon after a release is a late event, no stroke
  double pressure_seconds = 0.05;  ///< how long the first point waits for its pressure before it goes without
  double pressure_gamma = 1;       ///< pressure curve: pressure^gamma; below 1 is softer. > 0
};

/// What a PenInput has seen.
struct PenState {
  enum class Phase {
    Idle,
    Waiting,  ///< touching, but the first point has no pressure yet
    Drawing   ///< Begin was reported
  };

  PenOptions options;
  Phase phase = Phase::Idle;
  PenStep owner;                   ///< device, end, view and modifiers of the stroke under way or the last one
  std::vector<PenSample> samples;  ///< of the stroke under way or the last one
  bool has_pressure = false;       ///< of the stroke under way: some sample had one
  double ended = -1e300;           ///< when the last stroke ended

  std::optional<double> lost_since;    ///< sight of the drawing pen was lost
  std::vector<PenSample> trail;        ///< where the pen has been within twin_seconds
  double pen_seen = -1e300;            ///< its last event
  bool pen_touches = false;            ///< contact has been reported by a pen itself, not only by its mouse copy
  bool pen_muted = false;              ///< until it is lifted
  bool mouse_muted = false;            ///< until its button is up
  std::vector<PointerEvent> suspects;  ///< mouse events near a hovering pen, until it is clear whose they are
};

/// Turns the raw stream of tablet and mouse events into clean strokes.
///
/// Drivers send pen events, mouse copies of them, or both, in any order; proximity, presses and releases may be missing
/// or doubled, and the eraser bit may flip on the way. The rules:
/// - A stroke belongs to the device that began it. A pen that turns up while its own mouse copy draws takes over: the
///   copy's stroke is cancelled and the pen's begins with all its points.
/// - Mouse events near the pen in time and place are dropped until their button is up.
/// - The first point waits for its pressure.
/// - Losing sight of the pen (proximity, leaving the view) ends its stroke only if contact doesn't go on.
/// - A stroke whose release was lost ends at the next press, at a hover of its device, or on leaving.
/// - Fingers never draw.
/// Pure: time comes with the events. O(1) per event and O(samples of the last stroke) per mouse press.
class PenInput {
 public:
  explicit PenInput(PenOptions options = {}) { state_.options = options; }

  /// In the order in which they happened; mostly none or one.
  std::vector<PenStep> handle(const PointerEvent& event);

  /// Decides what still waits for an event that may never come. Optional; call it from a timer.
  std::vector<PenStep> settle(double now);

  /// Gives up the stroke under way (Escape); its device must be lifted before it draws again.
  std::vector<PenStep> cancel();

  /// Whether a stroke is under way.
  bool down() const { return state_.phase != PenState::Phase::Idle; }

  const PenOptions& options() const { return state_.options; }
  void set_options(PenOptions options) { state_.options = options; }

 private:
  PenState state_;
};

}  // namespace croquis
