// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {

/// Sets kind and companions of every hole from their measures. L log L plus the pairs of holes near each other.
void classify_holes(const PolyMesh& mesh, const HoleAnalysisOptions& options, HoleAnalysis& analysis);

}  // namespace croquis::hole_filling
