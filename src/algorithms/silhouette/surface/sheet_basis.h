// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "algorithms/silhouette/sampling/sheet_sampling.h"
#include "algorithms/silhouette/skeleton/skeleton.h"
#include "algorithms/silhouette/surface/sheet_operator.h"
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

}  // namespace croquis::silhouette
