// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "algorithms/silhouette/surface/sheet_sampling.h"

namespace croquis::silhouette {

/// Gives rims the section of a round tube: h^2 = 2 r d - d^2 at the depth d below a rim of radius r.
///
/// The thickness of a bent tube or of a blob is rounder in the mean than at its two rims. It is multiplied with a
/// factor that is smooth along the rim and fades to 1 at the depth r; at most a fifth, since a radius is uncertain
/// where a limb begins or a corner is drawn. Between the rim and its first row, points are laid onto the chord:
/// contours of other sheets bring points of any depth there, and beside the rim's other triangles a steeper one would
/// stand out.
/// @param thickness per lifted vertex, upright: without tilt
void shape_rims(const SheetSampling& sheets, Eigen::VectorXd& thickness);

}  // namespace croquis::silhouette
