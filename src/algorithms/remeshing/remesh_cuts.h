// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::remeshing {

/// Pairs of triangles that intersect, as find_self_intersections has them, (low, high), ascending; of a large mesh slab
/// by slab, on several threads. A slab lists a million pairs at most.
/// @throws Cancelled
std::vector<std::array<Index, 2>> find_cuts(const PolyMesh& mesh, int threads, Progress& progress);

}  // namespace croquis::remeshing
