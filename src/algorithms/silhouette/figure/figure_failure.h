// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/figure/contour_paths.h"
#include "algorithms/silhouette/figure/figure_search.h"
#include "algorithms/silhouette/figure/labelling.h"

/// Findings for a part whose hidden ends can't be joined or whose contours can't be labelled.
namespace croquis::silhouette {

/// E_NO_LABELLING for lines whose hidden ends can't all be paired, naming those that are left.
Finding ends_without_partner(const FigureContext& context, const PartLines& part);

/// E_NO_LABELLING naming the lines of which a labelling with slack had to break a rule.
Finding no_labelling(const FigureContext& context, const PartLines& part, const Arrangement& arrangement,
                     const Faces& faces, const Labelling& relaxed);

/// E_TOUCH at a place where contours meet in a way that no change of the completions resolves.
Finding contours_touch(const FigureContext& context, const PartLines& part, const Vec2& at);

}  // namespace croquis::silhouette
