// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/skeleton/depth.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// Reads what the drawing says of the objects of a figure into its settings, whose options and attachments are set:
/// - their weights: the options', unless the object's group sets others by "weight-curvature", "weight-orientation" or
///   "weight-distance";
/// - how deep each is against its width: 1, or a little less where it rests wholly before another one, unless
///   "thickness" says otherwise, of a named object's group or of the first of its strokes that says something.
/// @param findings is given one E_PARAMETER for every value that isn't a number in 1e-3..1 or, of a thickness, in
///                 0.05..4, naming the object
void read_object_weights(const LabelledFigure& figure, const Drawing& drawing, DepthSettings& settings,
                         Findings& findings);

}  // namespace croquis::silhouette
