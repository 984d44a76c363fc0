// SPDX-License-Identifier: GPL-3.0-or-later
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <algorithm>

#include "step/step_shape.h"

namespace croquis {
namespace {

/// How far, × its length, a cubic may be from a line at constant speed and count as one: rounding.
constexpr double straightness = 1e-12;

bool is_even_line(const RationalCubic& cubic) {
  const RationalCubic line = straight_cubic(cubic.points[0], cubic.points[3]);
  const double bound = straightness * (cubic.points[3] - cubic.points[0]).norm();
  return cubic.is_polynomial() && (line.points[1] - cubic.points[1]).norm() <= bound &&
         (line.points[2] - cubic.points[2]).norm() <= bound;
}

/// Knots that are written once with their numbers of times.
struct CountedKnots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger times;
};

CountedKnots counted(const std::vector<double>& knots) {
  const int count = static_cast<int>(knots.size()) - 6;  // the ends come four times, the others once
  CountedKnots result{TColStd_Array1OfReal(1, count), TColStd_Array1OfInteger(1, count)};
  for (int k = 1; k <= count; ++k) {
    result.values(k) = knots[static_cast<std::size_t>(k) + 2];
    result.times(k) = k == 1 || k == count ? 4 : 1;
  }
  return result;
}

}  // namespace

gp_Pnt to_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

StepCurve step_curve(const std::vector<RationalCubic>& cubics) {
  if (cubics.size() == 1 && is_even_line(cubics[0])) {
    const Vec3 along = cubics[0].points[3] - cubics[0].points[0];
    return {new Geom_Line(to_point(cubics[0].points[0]), gp_Dir(along.x(), along.y(), along.z())), along.norm()};
  }
  const int count = static_cast<int>(cubics.size());
  TColgp_Array1OfPnt points(1, 3 * count + 1);
  TColStd_Array1OfReal weights(1, 3 * count + 1), knots(1, count + 1);
  TColStd_Array1OfInteger times(1, count + 1);
  double weight = 1 / cubics[0].weights[0];  // so that cubics agree in the weight where they meet
  for (int c = 0; c < count; ++c) {
    const RationalCubic& cubic = cubics[static_cast<std::size_t>(c)];
    for (int k = c == 0 ? 0 : 1; k < 4; ++k) {
      points(3 * c + k + 1) = to_point(cubic.points[static_cast<std::size_t>(k)]);
      weights(3 * c + k + 1) = weight * cubic.weights[static_cast<std::size_t>(k)];
    }
    if (c + 1 < count) weight *= cubic.weights[3] / cubics[static_cast<std::size_t>(c) + 1].weights[0];
  }
  for (int k = 0; k <= count; ++k) {
    knots(k + 1) = static_cast<double>(k) / count;
    times(k + 1) = k == 0 || k == count ? 4 : 3;
  }
  if (std::ranges::all_of(cubics, &RationalCubic::is_polynomial)) {
    return {new Geom_BSplineCurve(points, knots, times, 3), 1};
  }
  return {new Geom_BSplineCurve(points, weights, knots, times, 3), 1};
}

Handle(Geom_Surface) step_plane(const Vec3& origin, const Vec3& normal) {
  return new Geom_Plane(to_point(origin), gp_Dir(normal.x(), normal.y(), normal.z()));
}

Handle(Geom_Surface) step_surface(const BicubicSpline& spline) {
  TColgp_Array2OfPnt points(1, static_cast<int>(spline.u_count()), 1, static_cast<int>(spline.v_count()));
  for (std::size_t i = 0; i < spline.u_count(); ++i) {
    for (std::size_t j = 0; j < spline.v_count(); ++j) {
      points(static_cast<int>(i) + 1, static_cast<int>(j) + 1) = to_point(spline.point(i, j));
    }
  }
  const CountedKnots u = counted(spline.u_knots), v = counted(spline.v_knots);
  return new Geom_BSplineSurface(points, u.values, v.values, u.times, v.times, 3, 3);
}

Handle(Geom2d_Curve) line_on_surface(const Vec2& from, const Vec2& to, double last) {
  TColgp_Array1OfPnt2d points(1, 2);
  points(1) = {from.x(), from.y()};
  points(2) = {to.x(), to.y()};
  TColStd_Array1OfReal knots(1, 2);
  knots(1) = 0;
  knots(2) = last;
  TColStd_Array1OfInteger times(1, 2);
  times.Init(2);
  return new Geom2d_BSplineCurve(points, knots, times, 1);
}

}  // namespace croquis
