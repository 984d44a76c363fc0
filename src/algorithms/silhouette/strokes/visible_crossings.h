// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

using LinePairs = std::set<std::pair<Index, Index>>;

struct HiddenEnd;

struct VisibleCrossings {
  LinePairs in_front;      ///< pairs of lines that cross; the first one lies in front
  std::set<Index> behind;  ///< the second ones of these pairs
  std::vector<int> sides;  ///< per line in front: its surface is on the left (+1) or right (-1)
  std::vector<CrossingInView> pairs;
  Findings findings;  ///< W_CROSS for every pair

  bool is_known(Index a, Index b) const { return in_front.contains({a, b}) || in_front.contains({b, a}); }
};

/// Reads lines that cross in full view, as two full circles over one another do: one of them passes behind.
///
/// Of two closed lines the one drawn later is in front, unless it is told to lie behind (stroke_data.h). A closed line
/// covers an open one. Two open lines, and a line that crosses itself, stay as they are: nothing tells which part is in
/// front. Where two lines nearly touch, an unsteady hand makes them cross several times, or not at all: the one behind
/// is moved there, so that what is left are crossings that were meant.
/// @param tubes_only other lines that cross stay as they are
/// @param lines     ends that pass behind something lie on it; moved where they nearly touch
VisibleCrossings order_visible_crossings(const Drawing& drawing, std::vector<CleanLine>& lines,
                                         const DrawingScale& scale, bool tubes_only, const Progress& progress);

/// Lines that still cross in full view (E_CROSS), run along one another or touch (E_TOUCH); one finding for each pair
/// of strokes. A stem and its bar meet rightly, and so do lines one of which is known to lie in front. O(n) for evenly
/// spread samples.
/// @param ends that lie on their bars
LineFindings find_line_conflicts(const Drawing& drawing, const std::vector<CleanLine>& lines,
                                 const std::vector<HiddenEnd>& ends, const VisibleCrossings& order,
                                 const DrawingScale& scale, const Progress& progress);

/// Pairs of lines that cross; the lower index first.
LinePairs crossing_pairs(const std::vector<CleanLine>& lines, const DrawingScale& scale);

}  // namespace croquis::silhouette
