// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// The arc length of a Bézier curve as a function of its parameter, by Gauss quadrature on parts that are halved until
/// it is exact to rounding.
class ArcLengths {
 public:
  explicit ArcLengths(const std::vector<Vec3>& control);

  double whole() const { return sums_.back(); }

  /// From the start to t in 0..1.
  double to(double t) const;

  /// The parameter of an arc length 0..whole().
  double parameter(double length) const;

  /// The same, found sooner from a guess that is nearly right.
  double parameter(double length, double guess) const;

  /// |C'(t)|.
  double speed(double t) const;

 private:
  double quadrature(double from, double to) const;
  void add_parts(double from, double to, double length, int depth);

  std::vector<Vec3> derivative_;
  double scale_ = 0;          ///< length of the control polygon
  std::vector<double> ends_;  ///< of the parts, the first 0, the last 1
  std::vector<double> sums_;  ///< arc length up to each of them
};

}  // namespace croquis
