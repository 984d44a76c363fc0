// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/skeleton/attachments.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

struct AttachedFigures {
  std::vector<Attachments> figures;  ///< per figure
  Findings warnings;                 ///< W_ATTACH_APART
};

/// Finds the objects that the options attach. A pair that doesn't overlap, or whose object couldn't be labelled, is
/// left out with a warning.
/// @throws Error with one E_ATTACH for every pair that names something unknown, or one object twice, or has a kappa
///         outside 0..1
AttachedFigures attached_figures(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options);

}  // namespace croquis::silhouette
