// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {

/// Fills all other measures of a hole from its vertices and corners.
void measure_hole(const PolyMesh& mesh, const SurfaceView& view, const HoleAnalysisOptions& options, Hole& hole,
                  Progress& progress);

}  // namespace croquis::hole_filling
