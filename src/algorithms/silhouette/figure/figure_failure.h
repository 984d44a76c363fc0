// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/figure/contour_paths.h"
#include "algorithms/silhouette/figure/labelling.h"

/// Findings for a part whose hidden ends can't be joined or whose contours can't be labelled.
namespace croquis::silhouette {

/// E_NO_LABELLING for lines whose hidden ends can't all be paired, naming those that are left.
Finding ends_without_partner(const FigureContext& context, const PartLines& part);

/// E_NO_LABELLING naming the lines of which a labelling with blame had to break a rule; E_TOUCH at a place where
/// contours meet in a way that nothing resolves, so that there are no faces.
Finding no_labelling(const FigureContext& context, const PartLines& part, const Arrangement& arrangement,
                     const Faces& faces);

}  // namespace croquis::silhouette
