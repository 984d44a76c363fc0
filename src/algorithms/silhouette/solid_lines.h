// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/solid.h"

namespace croquis::silhouette {

/// A line as it was drawn.
struct DrawnLine {
  Index stroke = 0;  ///< index into Drawing::strokes
  std::vector<Vec2> points;
  bool closed = false;
};

/// Carries lines onto the front of a solid, along the direction in which they were drawn. A line ends where there is
/// no surface, and where the surface in front is another one.
/// @param mesh    triangles
/// @param step    distance of the points, sketch units
std::vector<SurfaceLine> surface_lines(const std::vector<DrawnLine>& drawn, const PolyMesh& mesh, double step);

/// The pieces of lines, at least `3 * reach` long, that are farther than `reach` from all that figures show of their
/// contours: what was drawn as part of an outline, but lies within it.
std::vector<DrawnLine> inner_pieces(const std::vector<DrawnLine>& lines, const std::vector<LabelledFigure>& figures,
                                    double reach);

/// Appends a skeleton: its nodes with the vertex channel "radius", one polyline per branch between ends and junctions.
/// A loop returns to its first vertex. Nodes without edges stay vertices.
void append_skeleton(const Skeleton& skeleton, PolyMesh& curves);

}  // namespace croquis::silhouette
