// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

class ArcLengthTable;

/// A Bézier curve of any degree, walked along by the fraction s of its arc length: s = 0 at its start, 1 at its end.
///
/// Chordlength domains keep their promise only if curves are read at even speed: the speed of a Bézier curve would
/// distort the surface again. The curve is tabled by its arc length once, to 1e-13 of its length; curves that can't be,
/// since they nearly stop somewhere, are solved for each time. Immutable; reading allocates nothing.
class ArcLengthCurve {
 public:
  /// @param control both ends included, at least 2, finite, not all equal
  explicit ArcLengthCurve(std::vector<Vec3> control);

  /// Model units, > 0.
  double length() const { return length_; }
  const std::vector<Vec3>& control() const { return control_; }

  /// The curve's own parameter at s in 0..1, solved for.
  double parameter(double s) const;

  /// The place at s in 0..1; the ends are met exactly.
  Vec3 at(double s) const;

  /// The place and the derivative with respect to s, which is about length() long. Where the curve stands still (a
  /// control point that is repeated) the direction is that of the curve beside.
  struct Place {
    Vec3 point;
    Vec3 derivative;
  };
  Place place(double s) const;

  /// The derivative with respect to s at the start and the end.
  const Vec3& start_derivative() const { return start_derivative_; }
  const Vec3& end_derivative() const { return end_derivative_; }

  /// The fraction of the arc length at the curve's own parameter t in 0..1.
  double fraction(double t) const;

  std::size_t byte_size() const;

 private:
  std::vector<Vec3> control_;
  double length_ = 0;
  std::shared_ptr<const ArcLengthTable> table_;
  Vec3 start_derivative_ = Vec3::Zero();
  Vec3 end_derivative_ = Vec3::Zero();
};

/// Length of a Bézier curve, exact to rounding (Gauss quadrature on parts that are halved as needed). 0 when all
/// control points are equal.
/// @pre control is not empty
double bezier_length(const std::vector<Vec3>& control);

}  // namespace croquis
