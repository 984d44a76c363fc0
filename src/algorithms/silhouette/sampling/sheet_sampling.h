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

/// The immersed region sampled finely enough to carry a surface. The figure's points come first and keep their indices.
struct SheetSampling {
  std::vector<Vec2> points;
  std::vector<std::array<Index, 2>> segments;  ///< pieces of the contours, in the direction of their contour
  std::vector<Index> parents;                  ///< per piece, the segment of the figure
  std::vector<double> piece_radii;             ///< per piece, that of the surface there, see rim_radii
  std::vector<double> row_radii;               ///< per piece, that of its rows, see row_radii
  double step = 0;                             ///< of the contours' points
  PlanarTriangulation planar;                  ///< of the points, constrained to the pieces
  std::vector<int> layers;                     ///< per planar triangle
  LiftedTriangulation lifted;
};

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

/// Where the nodes of the skeleton lie in the sampled region, one place per node.
std::vector<LiftedPlace> locate_nodes(const LabelledFigure& figure, const Skeleton& skeleton,
                                      const SheetSampling& sheets);

}  // namespace croquis::silhouette
