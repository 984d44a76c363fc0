// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/stroke_chains.h"

namespace croquis::silhouette {

/// Per stroke the longer one that it was drawn over: both run beside one another closely, over most of the shorter
/// one's length. no_index for all others. Strokes that keep to one side of one another at a steady distance are two
/// outlines, such as the sides of a thin tube. O(n) for evenly spread samples.
std::vector<Index> doubled_strokes(const std::vector<SampledStroke>& strokes, const DrawingScale& scale);

/// Cuts off what open strokes draw once more of other ones, or of their own beginning, before they go on alone: a pen
/// often goes back a bit before a line goes on. Of two strokes the one drawn later is cut. O(n) as above.
void cut_retraced_ends(std::vector<SampledStroke>& strokes, const DrawingScale& scale);

}  // namespace croquis::silhouette
