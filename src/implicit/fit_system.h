// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "croquis/implicit/local_fit.h"

namespace croquis::implicit {

/// The points of a fit in their own unit box: shifted to its middle, divided by its longest side, without duplicates.
struct UnitCentres {
  Vec3 middle = Vec3::Zero();
  double size = 1;               ///< longest side, model units; 1 where all points are at one place
  std::vector<Vec3> positions;   ///< #C, within [-1/2, 1/2]
  std::vector<double> values;    ///< #C, of f / size
  std::vector<Vec3> gradients;   ///< #C, of f for model units; 0 where unknown
  std::vector<double> softness;  ///< #C, factor of the smoothing
  std::size_t merged = 0;
  double spacing = 0;  ///< u: mean distance of nearest neighbours, or the one asked for, / size

  bool has_gradient(std::size_t centre) const { return gradients[centre] != Vec3::Zero(); }
};

/// @throws Error (E_NO_POINTS, E_NOT_FINITE, E_COUNT), see LocalFit
UnitCentres unit_centres(const Constraints& constraints, const FitOptions& options);

/// The linear system of a fit (Yoo 2005, eq. 6, and its Hermite form), times the kernel's sign.
///
/// Unknowns are numbered centre by centre: a_j, then the three of b_j where the centre has a gradient.
struct FitSystem {
  std::vector<std::size_t> first;  ///< #C+1, the first unknown of every centre
  Eigen::MatrixXd a;               ///< both triangles, smoothing included
  Eigen::MatrixXd q;               ///< the side conditions' coefficients: 4 columns, or 1 for constants alone
  Eigen::VectorXd h;
  double sign = 1;  ///< a is sign times the kernel's matrix: weights come out sign times too large
};

FitSystem assemble(const UnitCentres& centres, const FitOptions& options);

}  // namespace croquis::implicit
