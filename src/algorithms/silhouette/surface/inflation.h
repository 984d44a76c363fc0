// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "algorithms/silhouette/sampling/sheet_sampling.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "algorithms/silhouette/surface/mid_surface.h"
#include "algorithms/silhouette/surface/thickness.h"
#include "croquis/base/progress.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// All of the sheets that doesn't depend on depths: a changed weight leaves it as it is.
struct SheetBasis {
  SheetSampling sampling;
  std::vector<LiftedPlace> nodes;  ///< where the skeleton's nodes lie
  SheetOperator op;
  NodeExtension extension;
  Eigen::VectorXd upright;            ///< per lifted vertex the thickness if the skeleton were level
  std::vector<Index> objects;         ///< per lifted triangle
  std::vector<Index> vertex_objects;  ///< per lifted vertex
  double unit = 1;                    ///< u
};

/// @param thin objects that are thinner than wide, see row_radii
/// @throws Error (E_INTERNAL) when the figure contradicts itself, Cancelled
SheetBasis make_sheet_basis(const LabelledFigure& figure, const Skeleton& skeleton, Quality quality,
                            std::span<const Index> thin, Progress& progress);

/// The object that each lifted triangle belongs to.
/// @throws Error (E_INTERNAL) when a component of the region is bounded by contours of two objects
std::vector<Index> objects_of_triangles(const LabelledFigure& figure, const SheetSampling& sheets);

/// u: what is left of a part's half thickness inside its rim, since files round to u / 100.
constexpr double least_half_thickness = 0.03;

/// Half thickness at a vertex of a part whose depth is multiplied by a factor.
double factored_thickness(const SheetBasis& basis, Eigen::Index vertex, double factor);

std::size_t bytes_of(const SheetBasis& basis);

/// The region with a front z + h and a back z - h over it, piecewise linear over one planar triangulation.
///
/// Wherever a sheet lies before another at a vertex, its back is at least the gap before the other's front; being
/// linear in between, no two sheets meet anywhere but those of attached objects.
struct InflatedSheets {
  SheetSampling sampling;
  Eigen::VectorXd thickness;  ///< per lifted vertex, h: 0 exactly on the boundary
  Eigen::VectorXd z;          ///< per lifted vertex
  std::vector<StackedPair> pairs;
  /// Nodes of objects that were laid down on what they rest on, and their heights there.
  std::vector<std::pair<Index, double>> lowered_nodes;
  double gap = 0;          ///< that they keep
  double resting_gap = 0;  ///< that one keeps which rests on another
  int iterations = 0;      ///< of the mid-surface's solver, the larger of both solves
  double residual = 0;
  std::vector<double> uncertainty;  ///< per object, L, of all solves: how far a height may still be from the optimum's

  double front(Index v) const { return z[v] + thickness[v]; }
  double back(Index v) const { return z[v] - thickness[v]; }
};

/// What a ball sweeps that runs along the skeleton with the radius of its nodes, seen over each node.
struct SweptLimbs {
  /// Per node its height in parts of what it would be if the skeleton were level, 1..2. Straight: sqrt(1 + slope^2).
  Eigen::VectorXd tilt;
  /// Per node how far its middle lies above the node: not 0 on the slopes of a bend.
  Eigen::VectorXd lift;
};

/// @param node_z per node
SweptLimbs swept_limbs(const Skeleton& skeleton, const Eigen::VectorXd& node_z);

/// From a skeleton with depths to sheets with thickness. The thickness is meant along the surface's normal: where the
/// skeleton is inclined, the vertical thickness grows, see swept_limbs.
/// @throws Error (E_INTERNAL) when the figure contradicts itself, Cancelled
InflatedSheets raise_sheets(const Skeleton& skeleton, const SheetBasis& basis, const DepthSettings& settings,
                            Progress& progress);

/// Middles of the sheets, which follow the surface that they rest on.
struct Draping {
  std::vector<Index> objects;  ///< that were laid down, ascending
  Eigen::VectorXd z;           ///< per lifted vertex; 0 of other objects
};

/// Lays every object that rests on others down on their fronts, the lower ones first: its middle then follows what lies
/// below everywhere, not only at the highest place. Where the surface below is steep or ends, the middle goes on from
/// there as little bent as it can, and levels out. What isn't much thinner than all that it rests on is moved as a
/// whole.
///
/// Objects that are joined to others, pass over themselves, or lie over one another all round stay as they are.
/// @param data    of the sheets' last solve
/// @param sheets  thickness and z of that solve; draped objects get the thickness that their inclination demands
/// One factorisation per draped object. @throws Cancelled
Draping drape_sheets(const Skeleton& skeleton, const SheetBasis& basis, const DepthSettings& settings,
                     const MidSurfaceData& data, InflatedSheets& sheets, Progress& progress);

}  // namespace croquis::silhouette
