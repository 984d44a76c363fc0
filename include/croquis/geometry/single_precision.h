// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Rounds coordinates to 32 bits.
inline void round_to_single(std::span<Vec3> points) {
  for (Vec3& point : points) {
    for (double& coordinate : point) {
      // Volatile: GCC 12 vectorises this loop so that x and y of the last points stay as they are.
      const volatile float rounded = static_cast<float>(coordinate);
      coordinate = static_cast<double>(rounded);
    }
  }
}

}  // namespace croquis
