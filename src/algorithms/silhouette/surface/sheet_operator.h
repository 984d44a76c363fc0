// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "algorithms/silhouette/sampling/sheet_sampling.h"

namespace croquis::silhouette {

/// Piecewise linear finite elements on the immersed region; the immersion is a local isometry, so that lengths and
/// angles are those of the plane.
struct SheetOperator {
  Eigen::SparseMatrix<double> stiffness;  ///< #V by #V, cotangent weights, free boundary: -div(w grad), integrated
  Eigen::VectorXd area;                   ///< #V, a third of the triangles around, times w
  std::vector<std::uint8_t> on_boundary;  ///< #V
  std::vector<Vec2> position;             ///< #V
};

/// @param weight per lifted vertex the weight w > 0, linear in between; empty: 1
SheetOperator make_sheet_operator(const SheetSampling& sheets, const Eigen::VectorXd& weight = {});

}  // namespace croquis::silhouette
