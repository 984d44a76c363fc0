// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "croquis/implicit/local_fit.h"
#include "implicit/unit_centres.h"

namespace croquis::implicit {

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
