// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "croquis/implicit/kernels.h"

namespace croquis::implicit {

/// Centres and weights of a fit in its unit box, column behind column: x, y, z, a and for kernels with
/// gradients bx, by, bz.
struct FitColumns {
  Kernel kernel;
  const double* columns;
  std::size_t stride;    ///< length of a column, whole lanes; unused rows have weights 0
  std::size_t directed;  ///< of kernels with gradients: from this row on, whole lanes, bx, by and bz are 0
};

/// Sum over the centres without the polynomial, all in the unit box.
/// @param gradients as many as points, or none
void evaluate_columns(const FitColumns& fit, std::span<const Vec3> points, std::span<double> values,
                      std::span<Vec3> gradients);

}  // namespace croquis::implicit
