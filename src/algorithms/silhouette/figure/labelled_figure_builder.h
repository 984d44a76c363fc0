// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "algorithms/silhouette/figure/contour_paths.h"
#include "algorithms/silhouette/figure/labelling.h"

namespace croquis::silhouette {

/// Puts the labelled figure together: contours, arcs and crossings as labelled, and the objects that its panels are
/// glued to (Williams 1994): across an arc of depth n, from the side with more layers, panel i goes on as i for i < n
/// and as i - 1 for i > n; panel n ends there. None when a contour would bound two components.
std::optional<LabelledFigure> build_figure(const FigureContext& context, const ClosedContours& closed,
                                           const Arrangement& arrangement, Faces faces, const Labelling& labelling);

/// Times that a closed polyline turns round, counter-clockwise positive; a region's Euler number is the sum of
/// side * turns over its contours.
int turning_number(const Points& points);

}  // namespace croquis::silhouette
