// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/figure/contour_completion.h"

namespace croquis::silhouette {

/// Sets the factor of candidates that carry both sides of a strip straight on behind something, at the same width: an
/// arrow through a heart, a stick behind a disc. Such a strip is one part, however far it is hidden: its sides cost
/// less.
///
/// Strips of which three or more would cross one another, and those that lie among limbs like their two ends, cost
/// more: they are petals or arms all round.
///
/// Behind something as narrow as another strip, the two sides may be bent aside and less even: there a hand's tremble
/// turns the ends of strands of knots and chains.
/// @param side per end: where the surface lies, walking outward, +1 left, -1 right, 0 not known
/// O(s²) for s straight candidates.
void favour_strips(const std::vector<CleanLine>& lines, const Junctions& junctions, const std::vector<Index>& ends,
                   const std::vector<int>& side, std::vector<CompletionCandidate>& candidates);

}  // namespace croquis::silhouette
