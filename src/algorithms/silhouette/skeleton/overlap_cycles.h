// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// Objects cut into those that lie over one another all round: strongly connected components of "lies over".
struct OverlapCycles {
  std::vector<Index> cycle;  ///< per object; what lies below a cycle, and isn't in it, has a smaller number
  Index count = 0;
};

/// @param below per object those that it lies over; itself and repetitions don't matter
/// Tarjan 1972. Linear.
OverlapCycles overlap_cycles(const std::vector<std::vector<Index>>& below);

}  // namespace croquis::silhouette
