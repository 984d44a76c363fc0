// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/sampling/rim_radius.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// A piece of a contour in its direction.
struct RimPiece {
  Vec2 begin = Vec2::Zero();
  Vec2 end = Vec2::Zero();
  Index contour = 0;
  Index position = 0;  ///< of the figure's segment that it is a piece of
  bool cut = false;    ///< begins where the segment was cut, not at a point of the figure
};

struct SheetRims {
  std::vector<RimPiece> pieces;                   ///< of the contours, already cut
  const std::vector<std::vector<double>>& radii;  ///< per contour and position, see row_radii
};

struct SheetDensity {
  std::size_t rows = RimRows::most;  ///< along every contour, at most
  double hexagon_spacing = 1.5;      ///< contour steps
};

/// Points inside the drawn region at which the sheets are to be sampled: rows along every contour, the skeleton's
/// nodes, and a hexagonal grid between them. None lies on a contour; all keep their distance from each other.
std::vector<Vec2> sheet_points(const LabelledFigure& figure, const Skeleton& skeleton, const SheetRims& rims,
                               const SheetDensity& density);

}  // namespace croquis::silhouette
