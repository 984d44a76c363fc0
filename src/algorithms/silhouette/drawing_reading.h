// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/strokes/junctions.h"
#include "algorithms/silhouette/strokes/stroke_cleanup.h"
#include "algorithms/silhouette/strokes/stroke_reading.h"
#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/base/progress.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// A drawing's lines and what their ends pass behind, before anything is completed.
struct ReadStrokes {
  CleanDrawing clean;        ///< lines carried on behind their bars
  VisibleCrossings crossed;  ///< its pieces are in the junctions
  Junctions junctions;
};

/// @throws Error when no stroke can be used; Cancelled
ReadStrokes read_strokes(const Drawing& drawing, const Options& options, const StrokeReading& reading,
                         Progress& progress);

/// Completes and labels what was read. All findings, those of the strokes first; without any figure when none can be
/// labelled.
LabelledDrawing label_strokes(const Drawing& drawing, const Options& options, const ReadStrokes& read,
                              Progress& progress);

}  // namespace croquis::silhouette
