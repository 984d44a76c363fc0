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

/// (7a) of Yoo 2005: 0 in the middle of the box, 1 on every face. Outside, where the printed formula becomes less than
/// 1 again as soon as two factors are negative, it is 1 here.
double box_distance(const Box& box, const Vec3& point);

/// (7b): 1 at d = 0, 0 at d = 1, there with first and second derivative 0; blend(d) + blend(1 - d) = 1.
double blend(double d);
double blend_derivative(double d);

struct BoxWeight {
  double value = 0;              ///< W in [0,1]
  Vec3 gradient = Vec3::Zero();  ///< of W, per model unit
};

/// W = blend(box_distance): twice continuously differentiable in all of space, 0 outside.
BoxWeight box_weight(const Box& box, const Vec3& point);

}  // namespace croquis::implicit
