// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algorithms/silhouette/sampling/sheet_sampling.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// Numbers along the contours: per contour and position.
using RimValues = std::vector<std::vector<double>>;

/// Along every contour.
constexpr std::size_t most_rows = 6;

/// Distances from the rim, in the plane and ascending, of the rows of points that run along every contour: without
/// close ones the silhouette would be serrated, since thickness grows like a square root at the rim.
///
/// On a tube they lie at 15, 35 and 60 degrees from the rim, seen from the axis; more of them gain nothing. On wider
/// bodies at distances along the surface that grow from two steps, where the plane's own points lie too far apart on
/// the steep surface. One at least, most_rows at most.
/// @param radius of the surface at the rim, @param step of the contour's points; sketch units
std::vector<double> row_depths(double radius, double step);

/// The most that the first row's depth can be of the radius.
double greatest_first_row();

/// The radius of the surface along the contours: that of the chords, filled in where none ends and smoothed. A contour
/// without any chord takes the skeleton's scale.
RimValues rim_radii(const Skeleton& skeleton);

/// Objects that are thinner than wide, ascending.
/// @param thickness per object the factor of its depth; empty: 1 for all
std::vector<Index> thin_objects(std::span<const double> thickness);

/// The radii by which rows are laid out: those of the surface, but for parts that are thinner than wide, whose back may
/// be flat. There rows as close to the rim as a round side needs them would make slender triangles on the back, so that
/// rows lie as far apart as they ever do.
/// @param radii see rim_radii
/// @param thin  objects of the figure, see thin_objects
RimValues row_radii(const LabelledFigure& figure, RimValues radii, std::span<const Index> thin);

/// An edge of the region's boundary, the surface on its left.
struct RimEdge {
  Index begin = 0;  ///< lifted vertices
  Index end = 0;
  double radius = 0;     ///< of its rows, see row_radii
  double first_row = 0;  ///< depth of the first of them
};

/// How far every sampled place is from the rim of its own sheet; rims of other sheets above the same place don't count.
struct RimDistances {
  std::vector<RimEdge> edges;
  std::vector<Index> nearest;    ///< per lifted vertex: its edge; no_index further away than the reach
  std::vector<double> distance;  ///< per lifted vertex; 0 on the boundary, infinite further away than the reach
};

/// Carried from vertex to vertex inwards, so that it stays in the sheet: exact where the nearest edge is also the
/// nearest one of a neighbour, or next to it. O(M).
/// @param reach how far to go, as a part of the radius at the rim
RimDistances rim_distances(const SheetSampling& sheets, double reach);

/// How deep a place lies under a rim's edge.
double depth_below(const SheetSampling& sheets, const RimEdge& edge, Index vertex);

}  // namespace croquis::silhouette
