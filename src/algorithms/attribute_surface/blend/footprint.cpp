// SPDX-License-Identifier: GPL-3.0-or-later
#include "footprint.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace croquis {
namespace {

/// Evenly turned from a to b, both unit.
Vec3 turned_between(const Vec3& a, const Vec3& b, double part) {
  const double angle = angle_between(a, b);
  if (std::sin(angle) < 1e-9) return ((1 - part) * a + part * b);
  return (std::sin((1 - part) * angle) * a + std::sin(part * angle) * b) / std::sin(angle);
}

Vec3 normal_between_keys(const NormalFence& fence, double at) {
  const auto next = std::ranges::upper_bound(fence.at, at);
  if (next == fence.at.begin()) return fence.normals.front();
  if (next == fence.at.end()) return fence.normals.back();
  const auto key = static_cast<std::size_t>(next - fence.at.begin()) - 1;
  const double part = (at - fence.at[key]) / (fence.at[key + 1] - fence.at[key]);
  return turned_between(fence.normals[key], fence.normals[key + 1], part);
}

/// Where conormals may have kinks: keys of the fence inside the extent, as fractions of it.
std::vector<double> breaks_in(const NormalFence& fence, const Footprint::Extent& extent) {
  std::vector<double> breaks{0};
  for (const double at : fence.at) {
    const double t = (at - extent.begin) / (extent.end - extent.begin);
    if (t > breaks.back() + 1e-9 && t < 1 - 1e-9) breaks.push_back(t);
  }
  breaks.push_back(1);
  return breaks;
}

}  // namespace

Vec3 fence_normal(const NormalFence& fence, double at, const Vec3& tangent) {
  const Vec3 normal = normal_between_keys(fence, at);
  const Vec3 projected = normal - normal.dot(tangent) * tangent;
  if (projected.norm() > 1e-9) return projected.normalized();
  return tangent.unitOrthogonal();
}

Footprint::Footprint(const DomainPolygon& polygon, std::size_t index, const SurfaceSide& side, const Extent& extent)
    : from(polygon.corners[index]), curve_(side.curve) {
  const Vec2 whole = polygon.corners[(index + 1) % polygon.corners.size()] - from;
  length = whole.norm();
  along = whole / length;
  inwards = left_of(along);
  first_ = side.reversed ? 1 - extent.begin : extent.begin;
  step_ = (side.reversed ? -1 : 1) * (extent.end - extent.begin);
  start_ = place(0);
  end_ = place(1);
  if (side.fence.empty()) return;

  const auto conormal_at = [&](double t) -> Vec3 {
    const Vec3 tangent = place(t).derivative.normalized();
    const double at = extent.begin + t * (extent.end - extent.begin);
    return side.fence.magnitude * fence_normal(side.fence, at, tangent).cross(tangent);
  };
  const PiecewiseQuintic<3>::Options options{.tolerance = 1e-10 * std::abs(side.fence.magnitude), .most_pieces = 64};
  conormals_ = std::make_shared<const PiecewiseQuintic<3>>(conormal_at, breaks_in(side.fence, extent), options);
}

ArcLengthCurve::Place Footprint::place(double t) const {
  ArcLengthCurve::Place result = curve_->place(t >= 1 ? first_ + step_ : fraction(t));
  result.derivative *= step_;
  return result;
}

}  // namespace croquis
