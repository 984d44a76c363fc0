// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/strokes/clean_line.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// The cheapest reading alone: `label` gives the same where it can be labelled, and else tries others, which takes many
/// times as long.
/// @throws Error when it can't be labelled or would lose lines; Cancelled
LabelledDrawing label_cheapest(const Drawing& drawing, const Options& options, Progress& progress);

/// The pins that a reading doesn't have.
std::vector<PinnedEnds> pins_lost(const std::vector<PinnedEnds>& pins, const LabelledDrawing& labelled);

/// Moves samples by far less than can be seen, so that no three of them lie on a line.
void bring_into_general_position(std::vector<CleanLine>& lines, double step);

}  // namespace croquis::silhouette
