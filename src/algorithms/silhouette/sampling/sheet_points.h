// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/sampling/sheet_sampling.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// Depths of the rows of points along the contours: per contour and position, see row_depths.
using RimRows = std::vector<std::vector<std::vector<double>>>;

/// Per segment of the figure: ascending fractions of it at which to cut it.
///
/// A contour that meets the rim of another sheet is an edge of that sheet's triangulation too, and where thickness
/// grows steeply its chord would cut a notch: it is cut where the rows along the rim would cut it.
std::vector<std::vector<double>> crossing_splits(const LabelledFigure& figure, const RimRows& rows);

/// Points inside the drawn region at which the sheets are to be sampled: rows along every contour, the skeleton's
/// nodes, and a hexagonal grid between them. None lies on a contour; all keep their distance from each other.
/// @param sheets the contours' points and pieces, already cut
std::vector<Vec2> sheet_points(const LabelledFigure& figure, const Skeleton& skeleton, const SheetSampling& sheets,
                               const RimRows& rows, Quality quality);

}  // namespace croquis::silhouette
