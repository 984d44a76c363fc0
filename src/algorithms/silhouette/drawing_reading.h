// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// The cheapest reading alone: `label` gives the same where it can be labelled, and else tries others, which takes many
/// times as long.
/// @throws Error when it can't be labelled or would lose lines; Cancelled
LabelledDrawing label_cheapest(const Drawing& drawing, const Options& options, Progress& progress);

}  // namespace croquis::silhouette
