// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/sampling/figure_segments.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// Per segment of the figure: ascending fractions of it at which to cut it.
///
/// A contour that meets the rim of another sheet is an edge of that sheet's triangulation too, and where thickness
/// grows steeply its chord would cut a notch: it is cut where the rows along the rim would cut it.
/// @param radii per contour and position, see row_radii
std::vector<std::vector<double>> crossing_splits(const LabelledFigure& figure,
                                                 const std::vector<DirectedSegment>& segments,
                                                 const std::vector<std::vector<double>>& radii);

}  // namespace croquis::silhouette
