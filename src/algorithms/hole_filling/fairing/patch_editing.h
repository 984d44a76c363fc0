// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// A patch by itself, while it is being improved.
struct LoosePatch {
  std::vector<Vec3> points;                     ///< those of the rims first
  std::vector<double> sizes;                    ///< #points, the edge length wanted there, > 0
  std::vector<std::array<Index, 3>> triangles;  ///< #T by 3
  std::size_t rim_points = 0;                   ///< how many stay as they are
};

/// The triangles' vertices, ascending.
std::vector<Index> vertices_of(std::span<const std::array<Index, 3>> triangles);

/// Mean length of the edges at each point, 0 where there is none.
/// @param edges pairs of points
std::vector<double> mean_lengths(std::span<const Vec3> points, std::span<const std::array<Index, 2>> edges);

/// Brings edges to the lengths wanted, once: those above 4/3 are split at their middle, those below 4/5 collapse unless
/// that would make one above 4/3 or turn a triangle over, then edges are flipped to the Delaunay side where the two
/// triangles look the same way. Edges of rims stay, and no further edge between two rim points is made.
/// (Botsch and Kobbelt 2004, section 4, without its last two steps.)
/// @return false when the triangles aren't manifold: nothing is changed
bool bring_to_size(LoosePatch& patch);

}  // namespace croquis::hole_filling
