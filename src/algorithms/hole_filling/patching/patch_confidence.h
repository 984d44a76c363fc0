// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// How far a patch is backed by the surface around it: 1 / (1 + (2 d)^4), where d is the greatest distance of the patch
/// to the nearest rim vertex, in units of the widest rim's diameter.
///
/// A narrow gap has nearly 1, a flat disc 0.5, a dome as high as half its diameter 0.2. The distance is taken at new
/// vertices, or without any at the middles of the inner edges.
double confidence_of(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis);

/// The same for each of the patch's new vertices: 1 / (1 + (2 d)^4) / (1 + (a / 45 degrees)^4), d its own distance and
/// a the angle between the faces at the rim, continued harmonically into the patch. 0..1, one per new vertex.
///
/// A patch that goes on smoothly keeps what distance leaves; one that meets the surface at 45 degrees has half of it.
/// Near-linear.
std::vector<float> vertex_confidence(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis);

/// A patch below this deserves a look: it goes higher than a dome of 0.35 diameters over a round rim.
inline constexpr double low_confidence = 0.3;

}  // namespace croquis::hole_filling
