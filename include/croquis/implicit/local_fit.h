// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/implicit/field.h"
#include "croquis/implicit/kernels.h"

namespace croquis::implicit {

/// What a field has to meet, point by point (Yoo 2005, eq. 3 and 4).
struct Constraints {
  std::vector<Vec3> positions;  ///< #N, model units
  std::vector<double> values;   ///< #N, or none: all 0, points on the surface
  std::vector<Vec3> gradients;  ///< #N, or none; unit normals outwards. 0 where unknown: that point has its value alone
  std::vector<double> softness = {};  ///< #N, or none: all 1; >= 0, factor of a point's smoothing: 0 is met exactly

  std::size_t size() const { return positions.size(); }
};

struct FitOptions {
  Kernel kernel = Kernel::Hermite;

  /// c_v: rho = c_v u^k is added to the rows of values, with the kernel's sign; u = spacing / size of the points' box,
  /// k = the kernel's degree, so that it means the same for any scale. 0 interpolates.
  double value_smoothing = 1;

  /// c_g: c_g u^(k - 2) is added to the rows of gradients. 0 interpolates.
  double gradient_smoothing = 5;

  /// Mean distance of neighbouring points, model units; 0: measured. Only smoothing uses it.
  double spacing = 0;
};

/// How a fit came out.
struct FitReport {
  std::size_t centres = 0;   ///< after merging
  std::size_t unknowns = 0;  ///< without the polynomial's
  std::size_t merged = 0;    ///< points at the place of another (within 1e-9 of the box), left out
  int polynomial_rank =
      0;  ///< 4, 10 with quadratic terms; 3 for centres in one plane, 1 for fewer than 4 centres without gradients
  bool rank_revealing = false;  ///< the fast solve broke down; a complete orthogonal decomposition did it
};

/// One radial basis function f(x) = sum_j [a_j phi(x - c_j) - b_j . grad phi(x - c_j)] + p0 + p . x, fitted to one set
/// of points (Yoo 2005, eq. 1-6; b_j = 0 but for Hermite kernels; p also quadratic for
/// Kernel::HermiteQuintic).
///
/// Coordinates are shifted and scaled to the unit box first: far from the origin or tiny, the digits are the same. The
/// side conditions are met by working in their null space, where the matrix is positive definite (Cholesky, half the
/// work of LU and stable without pivoting).
/// Fitting n unknowns takes n^3/3 multiplications and 16 n^2 bytes for a moment. Evaluating is thread-safe and linear
/// in the number of centres; the same bits for one point or many, on any machine.
class LocalFit {
 public:
  /// @param constraints at least one point; gradients are used by kernels that take them alone
  /// @throws Error (E_NO_POINTS, E_NOT_FINITE, E_COUNT, E_PARAMETER)
  LocalFit(const Constraints& constraints, const FitOptions& options);

  /// @param gradients as many as points, or none: not wanted
  void evaluate(std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients = {}) const;

  double value(const Vec3& point) const;
  Vec3 gradient(const Vec3& point) const;

  /// This as a field. It must outlive what it returns.
  Field field() const;

  const FitReport& report() const { return report_; }
  std::size_t bytes() const;

  /// Weight a_j of every centre, and b_j (#centres or none), in the unit box' own units; centres with gradients first.
  std::span<const double> value_weights() const;
  std::vector<Vec3> gradient_weights() const;

  /// p0, p1, p2, p3 for model coordinates, without quadratic terms.
  Eigen::Vector4d polynomial() const;

 private:
  Kernel kernel_;
  FitReport report_;
  Vec3 middle_ = Vec3::Zero();
  double size_ = 1;
  std::size_t stride_ = 0;       // centres, rounded up to whole lanes
  std::size_t directed_ = 0;     // those with gradients, which come first, rounded up likewise
  std::vector<double> columns_;  // x, y, z, a (, bx, by, bz), one behind the other, each stride_ long
  Eigen::Vector4d polynomial_ = Eigen::Vector4d::Zero();  // in the unit box
  Eigen::Matrix3d bend_ = Eigen::Matrix3d::Zero();        // second derivatives of the polynomial there
};

}  // namespace croquis::implicit
