// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "croquis/tools/holes/hole_pins.h"

namespace croquis::test {

/// A round hole in a surface that looks to +z.
inline HoleRim ring(Index id, const Vec3& at, double radius, int points = 24) {
  HoleRim rim{id, {}, at, Vec3::UnitZ(), radius};
  for (int i = 0; i < points; ++i) {
    const double angle = -2 * std::numbers::pi * i / points;
    rim.points.push_back(at + radius * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  return rim;
}

}  // namespace croquis::test
