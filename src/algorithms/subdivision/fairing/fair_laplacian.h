// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "algorithms/subdivision/levels/weight_rows.h"
#include "croquis/subdivision/level.h"

namespace croquis::subdivision {

/// The cotangent Laplacian of a level, #V by #V: applied to positions, a row's squared length is the squared mean
/// curvature (times 4) integrated around its vertex. Rows of the boundary, of sharp edges and of pins are empty.
WeightMatrix fair_laplacian(const Level& level, std::span<const Vec3> positions);

}  // namespace croquis::subdivision
