// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {

/// The mean angle between faces of edges that follow each other along the rims, radians: how much the surface around
/// turns there, by its shape or by roughness, which no method continues. Linear in the rims.
double rim_bend(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const Index> holes);

/// How far off a patch is likely to be, × diagonal of the model's piece:
/// 0.1 D (1 + 3 D) (0.02 + 4 D^2 + bend + fold). Fitted to known scans, but for 0.02 + 4 D^2, which says that what is
/// far from the rims is a guess, however smooth they are (docs/algorithms/hole_filling.md has predicted and true
/// errors).
/// @param depth D: the distance from the rims, × diagonal
/// @param bend see rim_bend
/// @param fold what the patch's turn at the rims counts, or 0
double predicted_error(double depth, double bend, double fold);

/// 1 / (1 + error / 0.01): a half where an error of one percent of the diagonal is predicted, 0.91 for a thousandth.
double confidence_in(double error);

/// 1 up to 90 degrees, then 1 / (1 + x^2) with x the excess over them in 30 degrees: a half at 120, a fifth at 150.
double trust_in_fold(double angle);

/// By the predicted error of a patch as far from its rims as it goes. Its fold: with a the angle between patch and
/// surface, meant over stretches of the rims so that the roughness of single faces evens out, 4 a^3, as only wide folds
/// are wrong; but 8 a without new vertices, where a flat patch leaves the surface, and a is the angle of the surface's
/// mean direction into the hole, if that is more.
///
/// Times trust_in_fold of the greatest angle between neighbouring faces of the patch, across its rims too. Patches
/// without new vertices are looked at evenly by area.
double confidence_of(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis);

/// The same for each of the patch's new vertices, by its own distance from the rims, and with the angle between the
/// faces at the rim, continued harmonically into the patch. 0..1, one per new vertex: falls from the rims to the
/// middle. Near-linear.
std::vector<float> vertex_confidence(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis);

/// A patch below this should be checked: more than 2.3 percent of the diagonal is predicted.
inline constexpr double low_confidence = 0.3;

}  // namespace croquis::hole_filling
