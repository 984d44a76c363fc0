// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// Two closed borders that run the same way: the left one's strip lies on its left, and ends at the right one.
struct ZipSides {
  std::vector<Vec3> left, right;                  ///< places, in order
  std::vector<Vec3> left_normals, right_normals;  ///< unit, of the surface that the strip is to be part of
};

/// The strip of triangles between both: corners below #left are points of the left side, #left + j is right[j].
///
/// Its edges are as short as can be for short sides, else the shorter one is taken each time (see band_triangulation).
/// Nothing where it would be twisted, as between sides that run against each other (closed and manifold as it would
/// be): when its edges are twice as long on average as the distances to the other side's nearest points. Nor where it
/// turns over: when triangles that look against the surface have more than a tenth of its area.
/// @throws Cancelled
std::optional<std::vector<std::array<Index, 3>>> zip(const ZipSides& sides, Progress& progress);

}  // namespace croquis::hole_filling
