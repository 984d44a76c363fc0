// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "croquis/implicit/kernels.h"

namespace croquis::hole_filling {

/// How Fairness::Implicit continues the surface: a radial basis function is fitted to vertices and normals around the
/// hole, and the patch lies where it is 0 (after Yoo 2005).
struct ImplicitOptions {
  implicit::Kernel kernel = implicit::Kernel::Hermite;
  double reach = 0.4;              ///< how far around the rim the surface counts, × the rim's diameter
  std::size_t most_centres = 250;  ///< of one fit; time grows with the third power
  double value_smoothing = 1;      ///< as implicit::FitOptions has it
  double gradient_smoothing = 5;   ///< as implicit::FitOptions has it
  bool both_sides = true;          ///< points off the surface, where the kernel needs them: false as in Yoo 2005
};

}  // namespace croquis::hole_filling
