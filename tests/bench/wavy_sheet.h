// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::bench {

/// A wavy sheet of side × side quads.
inline PolyMesh wavy_sheet(Index side) {
  PolyMesh mesh;
  for (Index y = 0; y <= side; ++y) {
    for (Index x = 0; x <= side; ++x) {
      mesh.positions.emplace_back(x, y, 0.02 * side * std::sin(0.05 * x) * std::cos(0.05 * y));
    }
  }
  for (Index y = 0; y < side; ++y) {
    for (Index x = 0; x < side; ++x) {
      const Index first = y * (side + 1) + x;
      mesh.add_face(std::vector<Index>{first, first + 1, first + side + 2, first + side + 1});
    }
  }
  return mesh;
}

}  // namespace croquis::bench
