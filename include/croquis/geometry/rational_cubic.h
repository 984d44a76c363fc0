// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>

#include "croquis/geometry/vector.h"

namespace croquis {

/// A rational Bézier cubic: Σ w_i P_i B_i(t) / Σ w_i B_i(t) with the cubic Bernstein polynomials B_i, t in 0..1. Equal
/// weights give a polynomial cubic.
struct RationalCubic {
  std::array<Vec3, 4> points{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< model units
  std::array<double, 4> weights{1, 1, 1, 1};                                           ///< all > 0

  bool is_polynomial() const;

  /// Ends are met exactly.
  Vec3 at(double t) const;

  /// With respect to t; model units.
  Vec3 derivative(double t) const;

  RationalCubic reversed() const;

  /// The parts before and after t, each again over 0..1.
  std::pair<RationalCubic, RationalCubic> split(double t) const;
};

/// The cubic that is a straight line at constant speed.
RationalCubic straight_cubic(const Vec3& from, const Vec3& to);

}  // namespace croquis
