// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/junctions.h"

namespace croquis::silhouette {

/// A hidden piece whose two ends pass behind the same line, kept behind what that line bounds: where it would come out
/// beside it, it follows the line within its surface instead.
/// @param curve from one end's place behind the bar to the other's, samples about a step apart
/// O(#P) samples of the curve, each by all of the bar.
Points kept_behind(Points curve, const CleanLine& bar, int bar_side, double step);

}  // namespace croquis::silhouette
