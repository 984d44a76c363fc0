// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/drawing.h"
#include "croquis/tools/pointer/pen.h"

namespace croquis {

/// How a view shows the sketch plane: without rotation, the same scale in x and y.
struct SketchFrame {
  Vec2 origin = Vec2::Zero();  ///< the place of the sketch plane at the view's top left corner, sketch units, y up
  double units_per_pixel = 1;  ///< > 0

  Vec2 to_sketch(const Vec2& pixel) const { return origin + units_per_pixel * Vec2(pixel.x(), -pixel.y()); }
  Vec2 to_pixel(const Vec2& place) const {
    const Vec2 offset = (place - origin) / units_per_pixel;
    return {offset.x(), -offset.y()};
  }
};

/// One step of a pen or mouse on the sketch plane.
struct SketchEvent {
  PenStep::Kind kind = PenStep::Kind::Begin;
  StrokeSample sample;         ///< its time by any clock; the tool counts it from the stroke's beginning
  bool erases = false;         ///< the pen's eraser end
  Modifiers modifiers;         ///< as they were at the beginning of the stroke
  double units_per_pixel = 1;  ///< of the view, > 0: scales every radius that is meant in pixels
  PointerEvent::Device device = PointerEvent::Device::Mouse;  ///< for recordings
  bool right = false;                                         ///< drawn with the right button
};

/// The step as it falls on the sketch plane.
inline SketchEvent to_sketch(const PenStep& step, const SketchFrame& frame) {
  const PenSample& at = step.sample;
  const StrokeSample sample{frame.to_sketch(at.position), at.pressure, at.tilt, at.time};
  return {step.kind, sample, step.erases, step.modifiers, frame.units_per_pixel, step.device, step.right};
}

}  // namespace croquis
