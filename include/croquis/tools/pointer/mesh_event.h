// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/vector.h"
#include "croquis/tools/pointer/pen.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis {

/// An upright box on the sketch plane, or of pixels.
struct PickBox {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();

  /// From any two opposite corners.
  static PickBox spanned(const Vec2& a, const Vec2& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

  bool has(const Vec2& place) const {
    return (place.array() >= low.array()).all() && (place.array() <= high.array()).all();
  }
};

/// One step of a pen or mouse in a view of the model.
struct MeshEvent {
  PenStep::Kind kind = PenStep::Kind::Begin;
  Vec2 pixel = Vec2::Zero();  ///< of the view, y down
  Modifiers modifiers;        ///< as they were at the beginning of the gesture
  ViewFrame frame;            ///< of the view that the gesture began in
  double time = 0;            ///< seconds by any clock; two clicks soon after one another are a double click
};

}  // namespace croquis
