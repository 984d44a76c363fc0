// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/reading/reading_program.h"
#include "algorithms/silhouette/strokes/junctions.h"
#include "algorithms/silhouette/strokes/stroke_cleanup.h"
#include "croquis/base/progress.h"

namespace croquis::silhouette {

/// The contours that a reading sees, as lines.
struct ContourLines {
  std::vector<CleanLine> lines;  ///< by the lowest stroke in them, then regions
  EndTargets targets;            ///< per line
  Findings findings;             ///< gaps closed
};

/// Joins the contours' strokes and the outlines of regions to lines, smooths them (Taubin 1995) and samples them
/// evenly.
/// @param passes of smoothing
ContourLines contour_lines(const Drawing& drawing, const SampledDrawing& sampled, const Connections& connections,
                           const Envelope& envelope, const Reading& reading, int passes, const Progress& progress);

}  // namespace croquis::silhouette
