// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algorithms/silhouette/skeleton/immersion.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/base/progress.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// A piece of one of the figure's segments, in the direction of its contour.
struct RimPiece : DirectedSegment {
  double radius = 0;      ///< of the surface there, see rim_radii
  double row_radius = 0;  ///< of its rows, see row_radii
};

/// The immersed region sampled finely enough to carry a surface. The figure's points come first and keep their indices.
struct SheetSampling {
  std::vector<Vec2> points;
  std::vector<RimPiece> pieces;  ///< of the contours
  double step = 0;               ///< of the contours' points
  PlanarTriangulation planar;    ///< of the points, constrained to the pieces
  std::vector<int> layers;       ///< per planar triangle
  LiftedTriangulation lifted;
};

/// The number of surfaces over every triangle, by a flood from outside: one more behind each piece on its surface's
/// side. Exact, O(#T).
/// @param pieces the constraints of the triangulation, in its order
/// @throws Error (E_INTERNAL) when two paths into a triangle contradict each other or a number is negative
std::vector<int> count_layers(const PlanarTriangulation& planar, std::span<const RimPiece> pieces);

/// Rows along the rims, cuts where contours cross, points between, all triangulated once and lifted. Every inner edge
/// of the region has an end inside: else the front and the back of the surface would share that edge.
/// A draft has one row along the rims and wider spaces between.
/// @param thin objects that are thinner than wide, see row_radii
/// @throws Error (E_INTERNAL) when the figure's contours can't be triangulated, Cancelled
SheetSampling sample_sheets(const LabelledFigure& figure, const Skeleton& skeleton, Progress& progress,
                            Quality quality = Quality::Final, std::span<const Index> thin = {});

/// A place in the region as a weighted mean of lifted vertices.
struct LiftedPlace {
  std::array<Index, 3> vertices{};
  std::array<double, 3> weights{};
};

/// Of a lifted triangle; a position outside of it counts as one nearby on its edge.
LiftedPlace place_in(const SheetSampling& sheets, Index triangle, const Vec2& position);

/// Where the nodes of the skeleton lie in the sampled region, one place per node.
std::vector<LiftedPlace> locate_nodes(const LabelledFigure& figure, const Skeleton& skeleton,
                                      const SheetSampling& sheets);

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
