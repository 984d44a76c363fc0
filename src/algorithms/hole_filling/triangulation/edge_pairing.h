// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

struct EdgePairing {
  std::vector<Index> opposite;  ///< #3T, as in SurfaceView
  std::size_t nonmanifold_edges = 0;
  std::vector<std::array<Index, 2>> nonmanifold_corners;  ///< of each non-manifold edge: (first corner, a further one)
};

/// Finds the triangles on both sides of every edge by sorting the edges' keys (low end, high end, corner): by lists or
/// counts of the low ends, then by comparison within each vertex. Where neighbours have near numbers it takes 4 bytes
/// per vertex beside the result, else 28 bytes per triangle.
/// @param triangles #T by 3, vertices below vertex_count, three different ones each
EdgePairing pair_edges(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count, Progress& progress);

}  // namespace croquis::hole_filling
