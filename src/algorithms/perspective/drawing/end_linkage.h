// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// A point to be grouped with those near it.
struct LinkagePoint {
  Vec2 place = Vec2::Zero();
  Index owner = 0;         ///< points of one owner stay apart …
  Index group = no_index;  ///< … but points of one group are together from the start, and different groups stay apart
};

/// Average linkage: the number of each point's cluster, counted in the order of the clusters' first points. Of equally
/// near pairs the first in the order of the points is joined.
std::vector<Index> link_nearest(const std::vector<LinkagePoint>& points, double limit);

}  // namespace croquis
