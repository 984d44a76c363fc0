// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"

/// Outlines beside, within and across one another.
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
std::optional<bool> hole_by_kind(const Drawing& drawing, const std::vector<Index>& strokes);

/// Leads closed lines into larger ones that they lie beside, no farther than hands miss by, where nothing ends
/// at them or crosses them: a head that was drawn next to its body grows out of it. Lines that lie within others stay,
/// and so do all where tolerances don't go by size. O(n) for evenly spread samples.
void lead_into_neighbours(std::vector<CleanLine>& lines, const DrawingScale& scale);

struct VisibleCrossings {
  std::set<std::pair<Index, Index>> in_front;  ///< pairs of lines that cross; the first one lies in front
  std::set<Index> behind;                      ///< the second ones of these pairs
  std::vector<int> sides;                      ///< per line in front: its surface is on the left (+1) or right (-1)
  std::vector<CrossingInView> pairs;           ///< but of lines that grow out of one another, and holes
  Findings findings;                           ///< W_CROSS for every pair
};

/// Reads lines that cross in full view, as two full circles over one another do: one of them passes behind.
///
/// Of two closed lines the one drawn later is in front, unless its strokes say that it lies behind (stroke_data.h). A
/// closed line covers an open one. Two open lines, and a line that crosses itself, stay as they are: nothing says which
/// part is in front. Where two lines nearly touch, an unsteady hand makes them cross several times, or not at all: the
/// one behind is moved there, so that what is left are crossings that were meant.
/// @param tubes_only other lines that cross stay as they are
/// @param lines     ends that pass behind something lie on it; moved where they nearly touch
VisibleCrossings order_visible_crossings(const Drawing& drawing, std::vector<CleanLine>& lines,
                                         const DrawingScale& scale, bool tubes_only, const Progress& progress);

}  // namespace croquis::silhouette
