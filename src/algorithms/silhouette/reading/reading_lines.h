// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/reading/reading_program.h"
#include "algorithms/silhouette/strokes/stroke_cleanup.h"
#include "croquis/base/progress.h"

namespace croquis::silhouette {

/// The contours that a reading sees, as lines.
struct ContourLines {
  std::vector<CleanLine> lines;  ///< by the lowest stroke in them, then regions
  Findings findings;             ///< gaps closed
};

/// Joins the contours' strokes and the outlines of regions to lines, smooths them (Taubin 1995) and samples them
/// evenly.
/// @param passes of smoothing
ContourLines contour_lines(const Drawing& drawing, const SampledDrawing& sampled, const Connections& connections,
                           const Envelope& envelope, const Reading& reading, int passes, const Progress& progress);

/// The outlines of the limbs that were drawn as one line: everything within half a limb's width of them, where they
/// leave what the contours bound, and a bit of it within, so that they grow out of it. Limbs that touch are one.
/// @param contours of the drawing, any number of them open
/// @param diagonal of the drawing
/// @returns closed lines, counter-clockwise, samples a step apart
std::vector<CleanLine> tube_outlines(const SampledDrawing& sampled, const Reading& reading,
                                     const std::vector<CleanLine>& contours, double diagonal);

}  // namespace croquis::silhouette
