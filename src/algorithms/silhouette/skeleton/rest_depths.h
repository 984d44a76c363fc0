// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/silhouette/skeleton/collision_rows.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/base/progress.h"

namespace croquis::silhouette {

/// How far the upper one of two different objects must at least lie before the lower one where both are flat; by
/// (upper, lower), sketch units.
using ObjectBounds = std::map<std::pair<Index, Index>, double>;

/// The largest bound of the rows between each two objects.
ObjectBounds object_bounds(const Skeleton& skeleton, std::span<const CollisionRow> rows);

/// Per object the height at which it would rest if it were flat and rigid: no nearer to what it lies over than the
/// bounds say, the objects that lie over one another as near to the same height as that allows, and like parts of one
/// body (legs, petals) equally far before or behind it.
///
/// Objects that lie over one another all round, as links do, share one height: none of them can be flat.
/// A larger object stays nearer to the sketch plane, and so does one with a larger weight of distance. The heights
/// don't depend on the order of objects or on where and how large the drawing is.
/// @return sketch units
/// @throws Cancelled
std::vector<double> rest_depths(const Skeleton& skeleton, const ObjectBounds& bounds, const DepthSettings& settings,
                                Progress& progress);

}  // namespace croquis::silhouette
