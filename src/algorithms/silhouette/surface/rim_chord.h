// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "algorithms/silhouette/sampling/sheet_sampling.h"

namespace croquis::silhouette {

/// Lays places between the rim and its first row of points onto the chord between the two.
///
/// Contours of other sheets bring points of any depth there. On the round section they would stand out beside the rim's
/// other triangles, which span from the rim to the row.
/// @param thickness per lifted vertex, upright: without tilt
void flatten_to_rim_chords(const SheetSampling& sheets, Eigen::VectorXd& thickness);

}  // namespace croquis::silhouette
