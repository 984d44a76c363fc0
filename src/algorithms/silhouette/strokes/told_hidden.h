// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/geometry/drawing.h"

namespace croquis::silhouette {

struct ToldHidden {
  std::vector<HiddenPiece> pieces;
  LineFindings findings;  ///< E_HIDDEN_STROKE for strokes that join no two ends; they are ignored
};

/// Reads the strokes that are told to be hidden (stroke_data.h): each is the hidden contour between the two ends of
/// lines that are nearest to its own ends, and is moved so that it begins and ends there. O(h l) for h such strokes.
/// @param lines that have met their bars
ToldHidden told_hidden(const Drawing& drawing, const std::vector<HiddenStroke>& hidden,
                       const std::vector<CleanLine>& lines, const DrawingScale& scale);

}  // namespace croquis::silhouette
