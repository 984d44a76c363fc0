// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/junctions.h"

namespace croquis::silhouette {

/// Leads closed lines into larger ones that they lie beside, no farther than hands miss by, where nothing ends
/// at them or crosses them: a head that was drawn next to its body grows out of it. Lines that lie within others stay,
/// and so do all where tolerances don't go by size. O(n) for evenly spread samples.
void lead_into_neighbours(std::vector<CleanLine>& lines, const EndTargets& targets, const DrawingScale& scale);

}  // namespace croquis::silhouette
