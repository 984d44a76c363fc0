// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "croquis/geometry/gregory_patch.h"

namespace croquis {

/// The 20 points of a patch, the boundary's first.
using PatchPoints = Eigen::Matrix<double, 20, 3>;

/// How much each point of a patch counts.
using PatchWeights = Eigen::Matrix<double, 20, 1>;

PatchPoints points_of(const GregoryPatch& patch);

/// The variation energy of a patch is the sum over coordinates of x' E x: squares of all third derivatives, by
/// differences, at the middles of a grid. It lets curvature be and resists its change, so that spheres stay round;
/// thin-plate energy flattens them.
const Eigen::Matrix<double, 20, 20>& variation_energy();

/// The second derivative at a place of the boundary across it, along u or v, by differences.
PatchWeights second_derivative(double u, double v, bool along_u);

}  // namespace croquis
