// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// How well a place in a hole is backed by the surface around it, 0..1: 1 / (1 + (2 d)^4) / (1 + (D / 0.3)^4), where d
/// is its distance to the rim in diameters of the hole and D the same in diagonals of the model's piece.
double backing(double distance, double diameter, double diagonal);

/// The least backing of a patch's places, / (1 + (a / 45 degrees)^4), where a is how far the patch turns away from the
/// surface at its rims: the mean fold of stretches of the rim, by which the roughness of single faces evens out.
/// Without new vertices it is the angle of the surface's mean direction into the hole, if that is more.
///
/// A narrow gap has nearly 1; a flat disc that continues a plane 0.5, or less where its diameter is over a third of the
/// piece; a dome as high as half its diameter 0.2. A lid across a tube has 0.03. Patches without new vertices are
/// looked at evenly by area.
double confidence_of(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis);

/// For each of the patch's new vertices: its backing / (1 + (a / 45 degrees)^4), a the angle between the faces at the
/// rim, continued harmonically into the patch. 0..1, one per new vertex.
///
/// A patch that goes on smoothly keeps what distance leaves; one that meets the surface at 45 degrees has half of it.
/// Near-linear.
std::vector<float> vertex_confidence(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis);

/// A patch below this should be checked: it goes higher than a dome of 0.35 diameters over a round rim.
inline constexpr double low_confidence = 0.3;

}  // namespace croquis::hole_filling
