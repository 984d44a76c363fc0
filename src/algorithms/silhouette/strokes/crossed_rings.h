// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/geometry/drawing.h"

namespace croquis::silhouette {

/// Of every line that others cross in full view: the closed line that it is a hole of, or no_index. The stroke's own
/// "kind" decides, else the shape of the ring between the two.
/// @param crossing pairs of lines, the lower index first
std::vector<Index> holes_of_rings(const Drawing& drawing, const std::vector<CleanLine>& lines,
                                  const std::set<std::pair<Index, Index>>& crossing);

}  // namespace croquis::silhouette
