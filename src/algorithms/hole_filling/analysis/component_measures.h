// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {

/// Area, diagonal and size of every component, and the component of every hole. Linear.
void measure_components(const PolyMesh& mesh, HoleAnalysis& analysis);

}  // namespace croquis::hole_filling
