// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// Finds the best reading of a drawing that can be labelled: what its strokes are, which of their ends meet, what they
/// pass behind, and what lies over what.
///
/// Readings are tried from the cheapest on (reading_program.h); one whose contours can't be labelled is excluded with
/// what its errors name. After some, only what the lines enclose is taken, with all lines in it as details: that can
/// always be labelled. Bounds are counts.
/// @returns all findings; without any figure when none can be labelled
/// @throws Error when no stroke can be used; Cancelled
LabelledDrawing read_drawing(const Drawing& drawing, const Options& options, Progress& progress);

}  // namespace croquis::silhouette
