// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/geometry/drawing.h"

namespace croquis::silhouette {

/// Warns (W_DOUBLE) of lines that run beside one another so closely and so long that one was drawn twice.
/// Nothing is merged: two sides of a thin tube look the same. O(n) for evenly spread samples.
Findings find_doubled_lines(const Drawing& drawing, const std::vector<CleanLine>& lines, const DrawingScale& scale);

}  // namespace croquis::silhouette
