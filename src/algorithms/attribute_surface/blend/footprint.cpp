// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/blend/footprint.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace croquis {
namespace {

/// Evenly turned from a to b, both unit, at that angle to each other.
Vec3 turned_between(const Vec3& a, const Vec3& b, double angle, double part) {
  if (std::sin(angle) < 1e-9) return (1 - part) * a + part * b;
  return (std::sin((1 - part) * angle) * a + std::sin(part * angle) * b) / std::sin(angle);
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

FenceReader::FenceReader(const NormalFence& fence) : fence_(fence) {
  for (std::size_t i = 0; i + 1 < fence.normals.size(); ++i) {
    angles_.push_back(angle_between(fence.normals[i], fence.normals[i + 1]));
  }
}

Vec3 FenceReader::normal(double at, const Vec3& tangent) const {
  const Vec3 between = between_keys(at);
  const Vec3 projected = between - between.dot(tangent) * tangent;
  const double size = projected.norm();
  return size > 1e-9 ? Vec3(projected / size) : Vec3(tangent.unitOrthogonal());
}

Vec3 FenceReader::between_keys(double at) const {
  const auto next = std::ranges::upper_bound(fence_.at, at);
  if (next == fence_.at.begin()) return fence_.normals.front();
  if (next == fence_.at.end()) return fence_.normals.back();
  const auto key = static_cast<std::size_t>(next - fence_.at.begin()) - 1;
  const double part = (at - fence_.at[key]) / (fence_.at[key + 1] - fence_.at[key]);
  return turned_between(fence_.normals[key], fence_.normals[key + 1], angles_[key], part);
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

  const FenceReader fence(side.fence);
  const auto conormal_at = [&](double t) -> Vec3 {
    const Vec3 tangent = place(t).derivative.normalized();
    const double at = extent.begin + t * (extent.end - extent.begin);
    return side.fence.magnitude * fence.normal(at, tangent).cross(tangent);
  };
  const PiecewiseQuintic::Options options{.tolerance = 1e-9 * std::abs(side.fence.magnitude), .most_pieces = 512};
  conormals_ = std::make_shared<const PiecewiseQuintic>(conormal_at, breaks_in(side.fence, extent), options);
}

ArcLengthCurve::Place Footprint::place(double t) const {
  ArcLengthCurve::Place result = curve_->place(t >= 1 ? first_ + step_ : fraction(t));
  result.derivative *= step_;
  return result;
}

}  // namespace croquis
