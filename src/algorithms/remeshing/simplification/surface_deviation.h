// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/triangle_tree.h"

namespace croquis::remeshing {

/// Triangles that aren't proven to lie within a distance of a surface with all their points, ascending. A proof is one
/// triangle of the surface that all corners are near to, since that holds for everything between them then; else
/// triangles are cut along the edges of what is nearest to their middle, or in halves, down to 2 % of the distance.
/// None is proven that has a point farther away; one that has a point almost so far may be missed.
/// @param guesses a triangle of the surface for each that may be near to all of it, or no_index; none: of no triangle
/// @throws Cancelled
std::vector<Index> faces_beyond(std::span<const std::array<Vec3, 3>> triangles, std::span<const Index> guesses,
                                const TriangleTree& surface, double distance, int threads, Progress& progress);

}  // namespace croquis::remeshing
