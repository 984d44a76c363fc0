// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/vector.h"

namespace croquis {

/// An upright box on the sketch plane, or of pixels.
struct PickBox {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();

  /// From any two opposite corners.
  static PickBox spanned(const Vec2& a, const Vec2& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }
};

}  // namespace croquis
