// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/drawing_reading.h"

namespace croquis::silhouette {

/// Whether strokes may be read otherwise than the plain rules say: only where tolerances go by size.
inline bool reads_again(const StrokeOptions& options) { return options.close_share > 0 || options.reach_share > 0; }

/// Where the first reading led to errors, tries others: which ends meet, and which reach farther. Strokes that lie
/// apart from those named in errors stay as they were read.
///
/// Best first: the reading with the fewest faults is changed further, one change at a time, near its faults. Bounded by
/// counts of readings and of labellings per independent part; a part that can't be read keeps the reading with the
/// fewest faults, so that what is told is what is left.
/// @param first   what came of the first reading
/// @param tremble of that reading, see `tremble_of`: an unsteady hand's drawing is read as a steady one's first
LabelledDrawing read_again(const Drawing& drawing, const Options& options, LabelledDrawing first, double tremble,
                           const Progress& progress);

}  // namespace croquis::silhouette
