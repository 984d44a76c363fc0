// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/geometry/vector.h"

namespace croquis::implicit {

/// An axis-parallel box, low <= high in every coordinate.
struct Box {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();

  bool contains(const Vec3& point) const {
    return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
  }
  Vec3 middle() const { return 0.5 * (low + high); }
  Vec3 size() const { return high - low; }

  /// Larger by `fraction` of its own size in total, per axis, about the same middle.
  Box grown(double fraction) const { return {low - 0.5 * fraction * size(), high + 0.5 * fraction * size()}; }
};

/// The smallest box around points; all 0 without any.
Box bounds(std::span<const Vec3> points);

struct BoxWeight {
  double value = 0;              ///< W in [0,1]
  Vec3 gradient = Vec3::Zero();  ///< of W, per model unit
};

/// W = 1 - 10 d^3 + 15 d^4 - 6 d^5 ((7b) of Yoo 2005) of the distance d = 1 - prod 4 (P - S)(T - P)/(T - S)^2 (7a): 1
/// in the middle of the box, 0 on every face, and twice continuously differentiable in all of space. Outside, where the
/// printed formula becomes positive again as soon as two factors are negative, it is 0.
BoxWeight box_weight(const Box& box, const Vec3& point);

}  // namespace croquis::implicit
