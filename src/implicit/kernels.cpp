// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/kernels.h"

#include <cmath>

#include "implicit/log.h"

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

Vec3 kernel_gradient(Kernel kernel, const Vec3& d) {
  const double squared = d.squaredNorm();
  if (squared == 0) return Vec3::Zero();
  switch (kernel) {
    case Kernel::Biharmonic: return d / std::sqrt(squared);
    case Kernel::ThinPlate: return (log_of_normal(squared) + 1) * d;
    case Kernel::HermiteQuintic: return 5 * squared * std::sqrt(squared) * d;
    case Kernel::Hermite:
    case Kernel::Triharmonic: break;
  }
  return 3 * std::sqrt(squared) * d;
}

Eigen::Matrix3d kernel_hessian(Kernel kernel, const Vec3& d) {
  using Eigen::Matrix3d;
  const double squared = d.squaredNorm();
  if (squared == 0) return Matrix3d::Zero();
  const double r = std::sqrt(squared);
  const Matrix3d outer = d * d.transpose() / squared;
  switch (kernel) {
    case Kernel::Biharmonic: return (Matrix3d::Identity() - outer) / r;
    case Kernel::ThinPlate: return (log_of_normal(squared) + 1) * Matrix3d::Identity() + 2 * outer;
    case Kernel::HermiteQuintic: return 5 * squared * r * (Matrix3d::Identity() + 3 * outer);
    case Kernel::Hermite:
    case Kernel::Triharmonic: break;
  }
  return 3 * r * (Matrix3d::Identity() + outer);
}

double portable_log(double x) { return log_of_normal(x); }

}  // namespace croquis::implicit
