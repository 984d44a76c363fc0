// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/skeleton.h"
#include "croquis/silhouette/labelled_figure.h"

#include <vector>

namespace croquis::silhouette {

/// Points inside the drawn region at which the sheets are to be sampled: rows along every contour, the skeleton's
/// nodes, and a hexagonal grid between them. None lies on a contour; all keep their distance from each other.
/// @param boundary the pieces of the contours, already cut
/// @param radii    per contour and position, see rim_radii
std::vector<Vec2> sheet_points(const LabelledFigure& figure, const Skeleton& skeleton,
                               const std::vector<std::array<Vec2, 2>>& boundary,
                               const std::vector<std::vector<double>>& radii);

}  // namespace croquis::silhouette
