// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// How far a patch is backed by the surface around it: 1 / (1 + (2 d)^4), where d is the greatest distance of the patch
/// to the nearest rim vertex, in units of the widest rim's diameter.
///
/// A narrow gap has nearly 1, a flat disc 0.5, a dome as high as half its diameter 0.2. The distance is taken at new
/// vertices, or without any at the middles of the inner edges.
double confidence_of(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis);

/// A patch below this deserves a look: it goes higher than a dome of 0.35 diameters over a round rim.
inline constexpr double low_confidence = 0.3;

}  // namespace croquis::hole_filling
