// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/skeleton/depth.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// The depth weights of every object of a figure: the options', unless the object's group sets others by
/// "weight-curvature", "weight-orientation" or "weight-distance".
/// @throws Error with one E_PARAMETER for every value that isn't a number in 1e-3..1, naming the object
std::vector<DepthWeights> object_weights(const LabelledFigure& figure, const Drawing& drawing,
                                         const DepthOptions& options);

/// How deep each object of a figure is against its width: 1, or a little less where it rests wholly before another one,
/// unless "thickness" says otherwise, of a named object's group or of the first of its strokes that says something.
/// @throws Error with one E_PARAMETER for every value that isn't a number in 0.05..4, naming the object
std::vector<double> object_thickness(const LabelledFigure& figure, const Drawing& drawing,
                                     const Attachments& attachments);

}  // namespace croquis::silhouette
