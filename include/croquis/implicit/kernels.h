// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/vector.h"

namespace croquis::implicit {

/// Basis functions phi(r), r the distance of a centre.
enum class Kernel {
  Hermite,        ///< r^3 with values and gradients (4 unknowns per centre): needs no points off the surface. Default
  Triharmonic,    ///< r^3, values alone; twice differentiable
  Biharmonic,     ///< r, values alone; its gradient jumps at the centres (Carr et al. 2001)
  ThinPlate,      ///< r^2 log r, values alone, phi(0) = 0 (Yoo 2005, eq. 2): the plane's thin plate, for comparison
  HermiteQuintic  ///< r^5 with values and gradients, quadratic polynomials: continues curvature, deviates farther off
};

/// Whether a fit by it takes gradients, and thus needs no points off the surface.
constexpr bool takes_gradients(Kernel kernel) { return kernel == Kernel::Hermite || kernel == Kernel::HermiteQuintic; }

/// What solvability needs to know of a kernel.
///
/// It is conditionally positive definite of order m: sign * sum_ij lambda_i lambda_j phi(|c_i - c_j|) > 0 for all
/// lambda != 0 that annul polynomials of degree < m at distinct centres.
struct KernelTraits {
  int order;   ///< m: 1 constants, 2 linear polynomials, 3 quadratic ones
  int sign;    ///< +1 or -1
  int degree;  ///< k: phi scales like r^k (r^2 log r up to a quadratic polynomial)
};
KernelTraits traits(Kernel kernel);

/// phi at the offset d = x - c, in any unit of length.
double kernel_value(Kernel kernel, const Vec3& d);

}  // namespace croquis::implicit
