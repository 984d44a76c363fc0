// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/curve_network.h"

namespace croquis {
namespace {

/// The first control point that isn't at the start tells it, also where handles have no length.
Vec3 starting_direction(const RationalCubic& cubic) {
  for (std::size_t i = 1; i < 4; ++i) {
    if (cubic.points[i] != cubic.points[0]) return (cubic.points[i] - cubic.points[0]).normalized();
  }
  return Vec3::Zero();
}

}  // namespace

Vec3 NetworkCurve::direction_from_start() const { return starting_direction(pieces.front()); }

Vec3 NetworkCurve::direction_from_end() const { return starting_direction(pieces.back().reversed()); }

}  // namespace croquis
