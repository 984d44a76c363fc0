// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/reading/reading_program.h"
#include "algorithms/silhouette/strokes/stroke_cleanup.h"

namespace croquis::silhouette {

/// The outlines of the limbs that were drawn as one line: everything within half a limb's width of them, where they
/// leave what the contours bound, and a bit of it within, so that they grow out of it. Limbs that touch are one.
/// @param contours of the drawing, any number of them open
/// @returns closed lines, counter-clockwise, samples a step apart
std::vector<CleanLine> tube_outlines(const SampledDrawing& sampled, const Reading& reading,
                                     const std::vector<CleanLine>& contours);

}  // namespace croquis::silhouette
