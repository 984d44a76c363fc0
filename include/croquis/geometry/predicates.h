// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/vector.h"

/// Signs of plane determinants, exact for all finite coordinates that neither overflow nor underflow.
namespace croquis {

/// +1 when c lies to the left of the line from a to b, -1 to the right, 0 on it.
int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// True when the segments a–b and c–d cross in one inner point of both.
inline bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

/// +1 when d lies strictly inside the circle through a, b, c (counter-clockwise), -1 strictly outside, 0 on it.
int in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

}  // namespace croquis
