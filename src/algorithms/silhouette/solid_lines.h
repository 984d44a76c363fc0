// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"
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

/// Cuts edges of a mesh in their middles: a triangle with k of them becomes k + 1, in its place in the order of faces.
/// Nothing opens, and what faces carry is kept.
/// @param mesh triangles with channels of faces alone
/// @param cuts whether an edge is cut, by one of its faces and its ends; asked for each of its faces until one does
/// @return whether any was cut
bool cut_edges(PolyMesh& mesh, const std::function<bool(Index face, const Vec3& a, const Vec3& b)>& cuts);

/// Makes the lines of a solid grooves or ridges, with finer triangles there. What faces the viewer moves along the
/// view, so that the outline stays as drawn: less towards it, and by a quarter of the way to the next surface at most.
/// Where the surface would meet itself, all get half the depth, up to three times. Lines that become none stay and are
/// named.
/// @param options of which the shape isn't Line
/// @param unit    diagonal of the sketch / 1000
/// @param solid   its mesh has channels of faces alone
/// @throws Cancelled
void carve_lines(const Drawing& drawing, const DetailOptions& options, double unit, Solid& solid, Progress& progress);

}  // namespace croquis::silhouette
