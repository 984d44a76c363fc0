// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/fences/corner_normals.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace croquis {
namespace {

/// Sines of the corner's angle: below the first the corner has no say, from the sum on it has all.
constexpr double least_sine = 0.02;
constexpr double sine_range = 0.18;

constexpr int newell_samples = 32;

double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Vec3 newell_normal(const std::vector<DirectedCurve>& loop) {
  const Vec3 origin = loop.front().at(0);
  Vec3 before = Vec3::Zero();
  Vec3 sum = Vec3::Zero();
  for (const DirectedCurve& side : loop) {
    for (int i = 1; i <= newell_samples; ++i) {
      const Vec3 point = side.at(static_cast<double>(i) / newell_samples) - origin;
      sum += before.cross(point);
      before = point;
    }
  }
  return unit_or_zero(sum);
}

Vec3 corner_normal(const Vec3& arriving, const Vec3& leaving, const Vec3& newell) {
  const Vec3 product = leaving.cross(-arriving);
  const double sine = product.norm();
  const double share = smooth_step((sine - least_sine) / sine_range);
  Vec3 normal = (1 - share) * unit_or_zero(newell - newell.dot(leaving) * leaving);
  if (share > 0) normal += share * (product.dot(newell) < 0 ? -1 : 1) / sine * product;
  return normal.norm() > 1e-9 ? Vec3(normal.normalized()) : Vec3(leaving.unitOrthogonal());
}

}  // namespace

Vec3 DirectedCurve::tangent(double t) const {
  const Vec3 along = curve->place(reversed ? 1 - t : t).derivative.normalized();
  return reversed ? Vec3(-along) : along;
}

LoopNormals loop_normals(const std::vector<DirectedCurve>& loop) {
  LoopNormals result;
  result.newell = newell_normal(loop);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const DirectedCurve& before = loop[(i + loop.size() - 1) % loop.size()];
    result.corners.push_back(corner_normal(before.tangent(1), loop[i].tangent(0), result.newell));
  }
  return result;
}

}  // namespace croquis
