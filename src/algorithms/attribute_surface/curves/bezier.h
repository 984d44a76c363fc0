// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// A place of a Bézier curve of any degree, without allocating (nested multiplication of the Bernstein form).
/// @pre control is not empty; t in 0..1
Vec3 bezier_of_any_degree(std::span<const Vec3> control, double t);

/// The same; up to cubics, which most curves are, written out.
inline Vec3 bezier_at(std::span<const Vec3> control, double t) {
  const double u = 1 - t;
  switch (control.size()) {
    case 2: return u * control[0] + t * control[1];
    case 3: return (u * u) * control[0] + (2 * u * t) * control[1] + (t * t) * control[2];
    case 4:
      return (u * u * u) * control[0] + (3 * u * u * t) * control[1] + (3 * u * t * t) * control[2] +
             (t * t * t) * control[3];
    default: return bezier_of_any_degree(control, t);
  }
}

/// Control points of the derivative: one less.
std::vector<Vec3> bezier_derivative(std::span<const Vec3> control);

}  // namespace croquis
