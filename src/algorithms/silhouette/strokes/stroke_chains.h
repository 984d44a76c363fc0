// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/gap_joining.h"

namespace croquis::silhouette {

/// The line that a chain of strokes makes, not smoothed yet. What runs on beyond the place where the next stroke (or
/// the first one again) goes on is cut off; ends that lie aside of one another are bent to meet when the drawing's
/// scale has an aside_share.
CleanLine join_chain(const StrokeChain& chain, const std::vector<SampledStroke>& strokes, const DrawingScale& scale);

}  // namespace croquis::silhouette
