// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/stroke_reading.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

struct CleanDrawing {
  DrawingScale scale;
  std::vector<CleanLine> lines;  ///< by the lowest stroke in them
  std::vector<HiddenStroke> hidden;
  std::vector<EndPair> joined;    ///< ends of strokes, see GapJoining
  std::vector<EndPair> possible;  ///< ends that might be joined too
  Findings findings;              ///< strokes left out, gaps closed, doubled lines
};

/// Step 1, stroke cleaning (Cordier, Seo, Cho 2006, section 3): strokes too short are left out, gaps joined, the rest
/// smoothed (Taubin 1995) and sampled evenly. No stroke is changed or deleted; the lines are copies.
/// @throws Error when nothing usable is left or the drawing is too long to sample; Cancelled
CleanDrawing clean_strokes(const Drawing& drawing, const StrokeOptions& options, const StrokeReading& reading,
                           const Progress& progress);

}  // namespace croquis::silhouette
