// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/figure/contour_completion.h"

namespace croquis::silhouette {

/// What is seen of a line when it is walked outward through a hidden end.
struct SeenEnd : HiddenEnd {
  Vec2 place = Vec2::Zero();       ///< behind the bar
  const SeenEnd* other = nullptr;  ///< at the line's other end; null where that isn't hidden
  int side = 0;                    ///< the surface lies left (+1) or right (-1), 0 where no stem tells it
  int likely_side = 1;             ///< the same, else by which way the line goes round
  /// How sure it is that the surface lies on the side that the line bends round: 1 for one that nearly closes, 0 for
  /// one whose ends are farther apart than half its length.
  double roundness = 0;
  double turning = 0;  ///< of the line, from its first to its last direction
  int handle = 0;  ///< outer (+1) or inner side (-1) of a handle: two lines from one thing, one goes round the other

  /// What both ends of a limb's outline pass behind; no_index for other lines.
  Index body() const { return other != nullptr && other->bar == bar && bar != line ? bar : no_index; }
};

/// Sets the factor of candidates that carry both sides of a strip straight on behind something, at the same width: an
/// arrow through a heart, a stick behind a disc. Such a strip is one part, however far it is hidden: its sides cost
/// less.
///
/// Strips of which three or more would cross one another, and those that lie among limbs like their two ends, cost
/// more: they are petals or arms all round.
///
/// Behind something as narrow as another strip, the two sides may be bent aside and less even: there a hand's tremble
/// turns the ends of strands of knots and chains.
/// O(s²) for s straight candidates.
void favour_strips(const std::vector<CleanLine>& lines, const std::vector<SeenEnd>& ends, double tremble,
                   std::vector<CompletionCandidate>& candidates);

}  // namespace croquis::silhouette
