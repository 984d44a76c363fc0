// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/rim_triangulation.h"

namespace croquis::hole_filling {

/// The triangulation of one closed polygon that folds least: the sum over edges of 1 - cos of the angle between their
/// triangles, the polygon's sides included, then that of `triangle_cost`. (Liepa 2003, section 2, takes the largest
/// angle alone. Where a ragged rim has one that can't be helped, everything below it is free then, and the patch may
/// fold.) It is chosen among `candidates`, among all triangles too on sides of the polygon that no candidate has, and
/// for short polygons among all triangles when that gives nothing. The choice depends on the numbers alone, not on the
/// order of the candidates.
/// @param polygon of one loop; `avoided` is not looked at
/// @param beyond #P, unit normals of the faces on the other side of the polygon's sides, each from a point to the next;
///        empty where there are none
/// @param candidates corners ascending
/// @return nothing when every triangulation has a triangle without area or a blocked edge
/// @throws Cancelled
std::optional<std::vector<std::array<Index, 3>>> dihedral_triangulation(const RimPolygon& polygon,
                                                                        std::span<const Vec3> beyond,
                                                                        std::vector<std::array<Index, 3>> candidates,
                                                                        Progress& progress);

}  // namespace croquis::hole_filling
