// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/arrangement_faces.h"
#include "algorithms/silhouette/contour_paths.h"
#include "algorithms/silhouette/figure_search.h"
#include "algorithms/silhouette/labelling.h"

namespace croquis::silhouette {

/// Puts the labelled figure together: contours, arcs and crossings as labelled, panels glued to objects.
LabelledFigure build_figure(const FigureContext& context, const ClosedContours& contours,
                            const Arrangement& arrangement, Faces faces, const Labelling& labelling);

}  // namespace croquis::silhouette
