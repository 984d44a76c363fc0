// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/figure/contour_paths.h"
#include "algorithms/silhouette/figure/figure_search.h"
#include "algorithms/silhouette/figure/labelling.h"

/// Findings for a part whose hidden ends can't be joined or whose contours can't be labelled.
namespace croquis::silhouette {

/// E_ODD, naming the end without which the rest is cheapest to join; nothing when the number of ends is even.
Findings odd_end(const FigureContext& context, const PartLines& part);

/// E_NO_PARTNER for every end without a candidate.
Findings ends_without_partner(const FigureContext& context, const PartLines& part);

/// E_NO_LABELLING for lines whose ends can't all be paired at once.
Finding no_pairing(const FigureContext& context, const PartLines& part);

/// E_NO_LABELLING naming the arcs that a labelling with slack had to break.
Finding no_labelling(const FigureContext& context, const PartLines& part, const Arrangement& arrangement,
                     const Labelling& relaxed);

/// E_TOUCH at a place where contours meet in a way that no change of the completions resolves.
Finding contours_touch(const FigureContext& context, const PartLines& part, const Vec2& at);

/// E_LIMIT when the search stopped early.
Finding search_limit(const FigureContext& context, const PartLines& part, int matchings);

}  // namespace croquis::silhouette
