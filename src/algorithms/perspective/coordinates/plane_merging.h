// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/perspective/coordinates/contradiction_search.h"

namespace croquis {

/// Makes planes of one axis that are nearly one to one, nearest ones first, as long as the drawing allows it: the sum
/// of squared residuals hardly rises, and no two vertices get to the same place. Without this coplanar faces that no
/// stroke ties together aren't seen as one plane.
/// @param tied  pairs of equal slots are added
/// @param now   the solution so far; replaced
/// @param sigma u, noise of the drawing's lines
/// @return distances are in the unit of the solution
std::vector<MergedPlanes> merge_planes(TiedVertices& tied, SolvedVertices& now, double sigma,
                                       const CoordinateOptions& options, Progress& progress);

/// Diagonal of the bounding box of one component's vertices, or of the largest one's for all.
double component_diagonal(const SolvedVertices& solved, Index component);

}  // namespace croquis
