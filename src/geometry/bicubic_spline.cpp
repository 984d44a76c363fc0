// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/bicubic_spline.h"

#include <algorithm>
#include <iterator>

namespace croquis {
namespace {

/// The polar form of a cubic: affine in each argument, and the curve where all three are equal.
Vec3 polar_form(const std::array<Vec3, 4>& bezier, double r, double s, double t) {
  const auto between = [](const Vec3& a, const Vec3& b, double at) -> Vec3 { return (1 - at) * a + at * b; };
  const Vec3 a = between(bezier[0], bezier[1], r), b = between(bezier[1], bezier[2], r);
  const Vec3 c = between(bezier[2], bezier[3], r);
  return between(between(a, b, s), between(b, c, s), t);
}

/// The knot that the span with t begins at.
std::size_t span_of(const std::vector<double>& knots, double t) {
  const auto after = std::upper_bound(knots.begin() + 4, knots.end() - 4, t);
  return static_cast<std::size_t>(std::distance(knots.begin(), after)) - 1;
}

}  // namespace

CubicSplineWeights cubic_spline_weights(const std::vector<double>& knots, double t) {
  const std::size_t span = span_of(knots, t);
  CubicSplineWeights result;
  result.first = span - 3;
  std::array<double, 4>& weight = result.value;
  weight[0] = 1;
  for (std::size_t degree = 1; degree <= 3; ++degree) {
    std::array<double, 4> lower = weight;
    weight.fill(0);
    for (std::size_t k = 0; k < degree; ++k) {
      const double left = knots[span + k + 1 - degree], right = knots[span + k + 1];
      const double share = lower[k] / (right - left);
      weight[k] += (right - t) * share;
      weight[k + 1] += (t - left) * share;
      if (degree < 3) continue;
      result.slope[k] -= 3 * share;
      result.slope[k + 1] += 3 * share;
    }
  }
  return result;
}

std::vector<Vec3> spline_points(const std::array<Vec3, 4>& bezier, const std::vector<double>& knots) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i + 4 < knots.size(); ++i) {
    points.push_back(polar_form(bezier, knots[i + 1], knots[i + 2], knots[i + 3]));
  }
  return points;
}

PatchPoint BicubicSpline::at(double u, double v) const {
  const CubicSplineWeights along_u = cubic_spline_weights(u_knots, u), along_v = cubic_spline_weights(v_knots, v);
  PatchPoint result;
  for (std::size_t b = 0; b < 4; ++b) {
    for (std::size_t a = 0; a < 4; ++a) {
      const Vec3& p = point(along_u.first + a, along_v.first + b);
      result.at += along_u.value[a] * along_v.value[b] * p;
      result.du += along_u.slope[a] * along_v.value[b] * p;
      result.dv += along_u.value[a] * along_v.slope[b] * p;
    }
  }
  return result;
}

}  // namespace croquis
