// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/figure/figure_search.h"

namespace croquis::silhouette {

/// Labels the parts of a drawing, each on its own as far as it can be.
///
/// Lines that stop at one another, or are forced into one object, are connected. Those whose bounding boxes overlap are
/// solved together; when that fails, as many of them as go together, so that one bad object doesn't exclude the others.
/// @param faults what is already known to be wrong with lines
LabelledDrawing label_parts(const FigureContext& context, const LineFindings& faults, const Progress& progress);

}  // namespace croquis::silhouette
