// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

struct VisibleCrossings {
  std::vector<HiddenPiece> pieces;  ///< what was cut out of the lines, between the ends it left
  std::vector<CrossingInView> pairs;
  Findings findings;  ///< W_CROSS for every pair
};

/// Reads lines that cross in full view, as two full circles over one another do: one of them passes behind, and what
/// lies inside the front one is cut out of it.
///
/// Of two closed lines the one drawn later is in front, unless it is told to lie behind (stroke_data.h). A closed line
/// covers an open one. Two open lines, and a line that crosses itself, stay as they are: nothing tells which part is in
/// front.
/// @param tubes_only other lines that cross stay as they are
/// @param lines     ends that pass behind something lie on it; cut lines are replaced by their pieces
VisibleCrossings cut_visible_crossings(const Drawing& drawing, std::vector<CleanLine>& lines, const DrawingScale& scale,
                                       bool tubes_only, const Progress& progress);

}  // namespace croquis::silhouette
