// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "algorithms/silhouette/figure/arrangement_faces.h"
#include "algorithms/silhouette/figure/contour_paths.h"
#include "algorithms/silhouette/figure/figure_search.h"
#include "algorithms/silhouette/figure/labelling.h"

namespace croquis::silhouette {

/// Puts the labelled figure together: contours, arcs and crossings as labelled, panels glued to objects.
std::optional<LabelledFigure> build_figure(const FigureContext& context, const ClosedContours& contours,
                                           const Arrangement& arrangement, Faces faces, const Labelling& labelling);

}  // namespace croquis::silhouette
