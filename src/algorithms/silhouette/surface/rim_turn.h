// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "algorithms/silhouette/sampling/sheet_sampling.h"

namespace croquis::silhouette {

/// Per lifted vertex of the boundary the curvature of the rim times the radius of the surface there: 1 around a disk, 0
/// along a straight tube, positive on the outer and negative on the inner side of a bend. 0 inside.
///
/// A mean over about a radius of the rim to either side, so that corners and the sampling's noise count as what they
/// turn in all.
Eigen::VectorXd rim_turn(const SheetSampling& sheets);

}  // namespace croquis::silhouette
