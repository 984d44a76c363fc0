// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/geometry/drawing.h"

namespace croquis::silhouette {

/// Warns (W_DOUBLE) of lines that run beside one another so closely and so long that one was drawn twice.
/// Lines that keep to one side of one another at a steady distance are two outlines, such as the sides of a thin tube.
/// Nothing is merged. O(n) for evenly spread samples.
Findings find_doubled_lines(const Drawing& drawing, const std::vector<CleanLine>& lines, const DrawingScale& scale);

}  // namespace croquis::silhouette
