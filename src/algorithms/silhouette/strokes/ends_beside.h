// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "algorithms/silhouette/strokes/bar_search.h"

namespace croquis::silhouette {

/// What was found for the start and the end of each line.
using EndHits = std::vector<std::array<std::optional<BarHit>, 2>>;

/// Two limbs beside one another end at one body. Where the hand trembled, the end of one comes to the side of the other
/// just before that one's own end: it is brought to the body beside it instead.
///
/// Only as near to the other end as the tremble explains. O(number of ends).
/// @param hits changed: bar, place on it, and how far its line is cut back
void pass_beside_ends(const std::vector<CleanLine>& lines, const DrawingScale& scale, EndHits& hits);

}  // namespace croquis::silhouette
