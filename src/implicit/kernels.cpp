// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/kernels.h"

#include <cmath>

#include "implicit/lanes.h"

namespace croquis::implicit {

KernelTraits traits(Kernel kernel) {
  switch (kernel) {
    case Kernel::Biharmonic: return {1, -1, 1};
    case Kernel::ThinPlate: return {2, 1, 2};
    case Kernel::HermiteQuintic: return {3, -1, 5};
    case Kernel::Hermite:
    case Kernel::Triharmonic: break;
  }
  return {2, 1, 3};
}

double kernel_value(Kernel kernel, const Vec3& d) {
  const double squared = d.squaredNorm();
  switch (kernel) {
    case Kernel::Biharmonic: return std::sqrt(squared);
    case Kernel::ThinPlate: return squared > 0 ? 0.5 * squared * log_of_normal(squared) : 0;
    case Kernel::HermiteQuintic: return squared * squared * std::sqrt(squared);
    case Kernel::Hermite:
    case Kernel::Triharmonic: break;
  }
  return squared * std::sqrt(squared);
}

}  // namespace croquis::implicit
