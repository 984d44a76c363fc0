// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "croquis/geometry/planar_triangulation.h"

namespace croquis::silhouette {

/// A constraint of a triangulation with surface on one side: (begin, end) and +1 for its left, -1 for its right.
struct SidedSegment {
  Index begin = 0;
  Index end = 0;
  int side = 1;
};

/// The number of surfaces over every triangle, by a flood from outside: one more behind each constraint on its
/// surface's side. Exact, O(#T).
/// @param segments the constraints of the triangulation, in its order
/// @throws Error (E_INTERNAL) when two paths into a triangle contradict each other or a number is negative
std::vector<int> count_layers(const PlanarTriangulation& planar, std::span<const SidedSegment> segments);

}  // namespace croquis::silhouette
