// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/silhouette/surface/shell.h"
#include "croquis/base/progress.h"

namespace croquis::silhouette {

struct ImprovedUnion {
  Shell surface;
  std::vector<Index> changed;   ///< ascending, faces that aren't those of the surface given
  std::vector<Index> vertices;  ///< per vertex the one of the surface given
};

/// Makes the slender triangles of a joined surface wider, next to its seams above all: edges are flipped, vertices
/// moved within the surface, or onto one another. The surface moves by no more than a seventeenth of the edges there, a
/// change moves a seam by no more than a fortieth and an outline by a 250th of the edge that takes its place; what
/// faces the viewer still does. Only what lies beside a triangle is looked at: that nothing meets has to be checked.
/// @param kept per vertex, triangles there stay as they are
/// O(n) in practice.
ImprovedUnion improve_union(const Shell& joined, const std::vector<std::uint8_t>& kept, Progress& progress);

}  // namespace croquis::silhouette
