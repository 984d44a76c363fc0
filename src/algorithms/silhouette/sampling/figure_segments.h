// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// A segment of a figure in the direction of its contour.
struct DirectedSegment {
  Index contour = no_index;
  Index position = 0;  ///< in the contour's vertices
  Index begin = 0;     ///< points
  Index end = 0;
  int side = 1;   ///< +1: the surface lies on its left
  int depth = 0;  ///< surfaces in front
};

/// One per entry of LabelledFigure::segments. O(n log n).
std::vector<DirectedSegment> directed_segments(const LabelledFigure& figure);

/// Per contour and position, the index of the segment that starts there.
std::vector<std::vector<Index>> segments_of_contours(const LabelledFigure& figure,
                                                     const std::vector<DirectedSegment>& segments);

/// The corner of the figure's bounding box with the least, and the one with the greatest coordinates.
std::array<Vec2, 2> bounds_of(const std::vector<Vec2>& points);

}  // namespace croquis::silhouette
