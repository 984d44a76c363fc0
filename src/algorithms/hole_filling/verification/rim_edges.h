// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {

/// Sorted pairs (low, high) of the view's vertices that lie on holes' rims and are joined by an edge. Linear.
std::vector<std::array<Index, 2>> edges_between_rims(const PolyMesh& mesh, const HoleAnalysis& analysis);

}  // namespace croquis::hole_filling
