// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/hole_filling/surface_reach.h"

namespace croquis::hole_filling {

/// A place on a part of the surface that passes by a hole, with its unit normal.
struct PassingPoint {
  Vec3 position;
  Vec3 normal;
};

/// Sparse points of the sheets that come nearer to a rim vertex than `reach` without being joined to the rims within
/// that way. Middles of triangles, no two nearer than `spacing`; that grows until they are `most` at most.
/// Linear in the view.
std::vector<PassingPoint> other_sheets(const HoleSite& site, const std::vector<ReachedVertex>& reached, double reach,
                                       double spacing, std::size_t most);

}  // namespace croquis::hole_filling
