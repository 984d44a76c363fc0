// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/stroke_chains.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// Things of a typical size measure at least so many u: a sheet of many small things is read as one of them is.
inline constexpr double least_typical_size = 150;

/// The strokes of a drawing that can be read.
struct SampledDrawing {
  DrawingScale scale;
  std::vector<SampledStroke> strokes;  ///< samples half a step apart
  std::vector<SampledStroke> hidden;   ///< told to be
  std::vector<Index> dots;             ///< indices into Drawing::strokes: too short to be a line of anything
  Findings findings;
};

/// Step 1, stroke cleaning (Cordier, Seo, Cho 2006, section 3): strokes too short to be lines are set apart, the rest
/// sampled evenly. No stroke is changed or deleted; the samples are copies.
/// @param typical size of the things on the sheet (see `size_of`), which makes u finer where they are small; 0: not
/// known
/// @throws Error when nothing usable is left or the drawing is too long to sample
SampledDrawing sample_strokes(const Drawing& drawing, const StrokeOptions& options, double typical = 0);

}  // namespace croquis::silhouette
