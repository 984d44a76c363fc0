// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "algorithms/silhouette/surface/mid_surface.h"
#include "algorithms/silhouette/surface/sheet_basis.h"
#include "croquis/base/progress.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

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

}  // namespace croquis::silhouette
