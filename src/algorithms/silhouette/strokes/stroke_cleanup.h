// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// Things of a typical size measure at least so many u: a sheet of many small things is read as one of them is.
inline constexpr double least_typical_size = 150;

/// The strokes of a drawing that can be read.
struct SampledDrawing {
  DrawingScale scale;
  int smoothing_passes = 0;
  std::vector<SampledStroke> strokes;  ///< samples half a step apart
  std::vector<SampledStroke> hidden;   ///< those of kind "hidden"
  std::vector<Index> dots;             ///< indices into Drawing::strokes: too short to be a line of anything
  Findings findings;
};

/// Step 1, stroke cleaning (Cordier, Seo, Cho 2006, section 3): strokes too short to be lines are set apart, the rest
/// sampled evenly. What open strokes draw once more of other ones, or of their own beginning, before they go on alone
/// is cut off: a pen often goes back a bit before a line goes on. Of two strokes the one drawn later is cut. No stroke
/// of the drawing is changed or deleted; the samples are copies. O(n) for evenly spread samples.
/// @param typical size of the things on the sheet (see `size_of`), which makes u finer where they are small; 0: not
/// known
/// @throws Error when nothing usable is left or the drawing is too long to sample
SampledDrawing sample_strokes(const Drawing& drawing, const StrokeOptions& options, double typical = 0);

/// Per stroke the longer one that it was drawn over: both run beside one another closely, over most of the shorter
/// one's length. no_index for all others. Strokes that keep to one side of one another at a steady distance are two
/// outlines, such as the sides of a thin tube. O(n) for evenly spread samples.
std::vector<Index> doubled_strokes(const std::vector<SampledStroke>& strokes, const DrawingScale& scale);

}  // namespace croquis::silhouette
