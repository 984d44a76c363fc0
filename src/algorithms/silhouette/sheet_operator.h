// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/sheet_sampling.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace croquis::silhouette {

/// Second derivatives at a vertex: xx, xy, yy.
using Hessian = Eigen::Vector3d;

/// Piecewise linear finite elements on the immersed region; the immersion is a local isometry, so that lengths and
/// angles are those of the plane.
struct SheetOperator {
  Eigen::SparseMatrix<double> stiffness;  ///< #V by #V, cotangent weights, free boundary: -Lap, integrated
  Eigen::VectorXd area;                   ///< #V, a third of the triangles around
  std::vector<std::uint8_t> on_boundary;  ///< #V
  std::vector<Vec2> position;             ///< #V
};

SheetOperator make_sheet_operator(const SheetSampling& sheets);

/// Second derivatives of a function given at the vertices: least-squares quadratics over the vertices within two edges,
/// averaged over the neighbours since linear elements leave noise of the mesh's wavelength. O(#V).
std::vector<Hessian> recover_hessians(const SheetOperator& op, const Eigen::VectorXd& values);

/// What `stiffness` gives at inner vertices for a function with these second derivatives, exact for cubic polynomials.
/// (Linear elements give the true -area * trace only on regular meshes. Where rows of points or a foreign contour cross
/// a sheet, the difference would show as a faint line on the surface.) Zero at the boundary.
Eigen::VectorXd apply_to_hessians(const SheetOperator& op, const std::vector<Hessian>& hessians);

}  // namespace croquis::silhouette
