// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// One warning (W_COLLISION) for every place where parts couldn't be separated, with the strokes of both.
Findings depth_findings(const DepthResult& result, const Skeleton& skeleton, const LabelledFigure& figure,
                        const Drawing& drawing);

}  // namespace croquis::silhouette
