// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "croquis/subdivision/level.h"

namespace croquis::subdivision {

/// Of unit length, or zero where the vector is too short to have a direction.
Vec3 unit_or_zero(const Vec3& vector);

/// Sharpness of each edge, 0 where there is no tag, infinite on the boundary.
std::vector<double> edge_sharpness(const Level& level);

/// Calls use(corner) for the corners of a vertex counter-clockwise, from its `vertex_corner`.
template <typename Use>
void for_each_corner(const HalfEdges& mesh, const CornerFaces& around, Index vertex, Use&& use) {
  const Index start = mesh.vertex_corner[vertex];
  Index corner = start;
  do {
    use(corner);
    corner = mesh.twin[around.previous(corner)];
  } while (corner != no_index && corner != start);
}

}  // namespace croquis::subdivision
