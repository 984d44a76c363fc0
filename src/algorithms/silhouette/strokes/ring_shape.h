// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/silhouette/strokes/polyline.h"
#include "croquis/geometry/drawing.h"

namespace croquis::silhouette {

/// Whether a closed outline within another looks like the hole of a ring, rather than like a part that lies in front.
///
/// Holes are what rings of even width go round, along most of the outline. The thicker the ring for its hole, the more
/// do other things speak for a part: a belly or an eye on a body rather than a ring.
/// O(#inner + 64 #outer).
/// @param things what covers the outer outline or is covered by it, and what else lies within it
bool is_hole_of_ring(const Points& inner, const Points& outer, std::size_t things);

/// Whether the "kind" of an outline's strokes says that it bounds a hole; none where it says nothing of it.
/// @param strokes indices into Drawing::strokes
std::optional<bool> told_hole(const Drawing& drawing, const std::vector<Index>& strokes);

}  // namespace croquis::silhouette
