// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/junctions.h"
#include "croquis/base/progress.h"

namespace croquis::silhouette {

/// Finds lines that cross in full view (E_CROSS), run along one another or touch (E_TOUCH); one finding for each pair
/// of strokes. A stem and its bar meet rightly, and so do lines one of which is known to lie in front. O(n) for evenly
/// spread samples.
LineFindings find_line_conflicts(const Drawing& drawing, const std::vector<CleanLine>& lines,
                                 const std::vector<HiddenEnd>& ends, const VisibleCrossings& order,
                                 const DrawingScale& scale, const Progress& progress);

}  // namespace croquis::silhouette
