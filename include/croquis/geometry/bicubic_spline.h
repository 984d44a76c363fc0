// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "croquis/geometry/gregory_patch.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// The four cubic B-splines that aren't zero at a parameter.
struct CubicSplineWeights {
  std::size_t first = 0;  ///< number of the first of them
  std::array<double, 4> value{};
  std::array<double, 4> slope{};  ///< derivatives with respect to the parameter
};

/// Cox and de Boor's recurrence. At an inner knot: of the span that begins there.
/// @param knots ascending, the first and the last one four times
/// @param t from the first knot to the last one
CubicSplineWeights cubic_spline_weights(const std::vector<double>& knots, double t);

/// Control points of a polynomial cubic over 0..1 as a B-spline with these knots: the same curve, by its polar form
/// (Ramshaw 1989). The ends are kept to the bit.
/// @param knots as above, from 0 to 1
std::vector<Vec3> spline_points(const std::array<Vec3, 4>& bezier, const std::vector<double>& knots);

/// A tensor product B-spline surface of degree 3 in both directions. Inner knots are simple: second derivatives are
/// continuous.
struct BicubicSpline {
  std::vector<double> u_knots;  ///< four times 0, inner ones ascending, four times 1
  std::vector<double> v_knots;
  std::vector<Vec3> points;  ///< model units; row by row, u runs along a row: points[j * u_count() + i]

  std::size_t u_count() const { return u_knots.size() - 4; }
  std::size_t v_count() const { return v_knots.size() - 4; }
  Vec3& point(std::size_t i, std::size_t j) { return points[j * u_count() + i]; }
  const Vec3& point(std::size_t i, std::size_t j) const { return points[j * u_count() + i]; }

  /// @param u,v 0..1
  PatchPoint at(double u, double v) const;
};

}  // namespace croquis
