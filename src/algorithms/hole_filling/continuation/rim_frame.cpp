// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/rim_frame.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace croquis::hole_filling {
namespace {

constexpr double least_area = 1e-3;  // × squared size of the rims, of what they go round: else it shows no direction

/// Of the points, without the part along an axis the longest way from the middle; the first of equals.
Vec3 farthest_aside(const std::vector<Vec3>& points, const Vec3& middle, const Vec3& axis) {
  Vec3 farthest = Vec3::Zero();
  for (const Vec3& point : points) {
    const Vec3 away = point - middle, aside = away - away.dot(axis) * axis;
    if (aside.squaredNorm() > (1 + 1e-9) * farthest.squaredNorm()) farthest = aside;
  }
  return farthest;
}

}  // namespace

RimFrame::RimFrame(const HoleSite& site) {
  const std::vector<Vec3>& points = site.polygon.points;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point - points.front();
  middle_ = points.front() + sum / static_cast<double>(points.size());
  Vec3 area = Vec3::Zero();
  double size = 0;
  for (Index i = 0; i < points.size(); ++i) {
    area += 0.5 * (points[i] - middle_).cross(points[site.polygon.next(i)] - middle_);
    size = std::max(size, (points[i] - middle_).squaredNorm());
  }
  if (!(area.norm() > least_area * size)) area = farthest_aside(points, middle_, Vec3::Zero());
  if (!(area.norm() > 0)) return;
  const Vec3 z = area.normalized();
  const Vec3 aside = farthest_aside(points, middle_, z);
  const Vec3 x = aside.norm() > 0 ? Vec3(aside.normalized()) : Vec3(z.unitOrthogonal());
  axes_.row(0) = x;
  axes_.row(1) = z.cross(x);
  axes_.row(2) = z;
}

std::vector<Vec3> RimFrame::into(std::span<const Vec3> places) const {
  std::vector<Vec3> turned;
  turned.reserve(places.size());
  for (const Vec3& place : places) turned.push_back(into(place));
  return turned;
}

std::vector<Vec3> RimFrame::out_of(std::span<const Vec3> places) const {
  std::vector<Vec3> turned;
  turned.reserve(places.size());
  for (const Vec3& place : places) turned.push_back(out_of(place));
  return turned;
}

implicit::Box RimFrame::around(const implicit::Box& box) const {
  std::vector<Vec3> corners;
  for (const double x : {box.low.x(), box.high.x()})
    for (const double y : {box.low.y(), box.high.y()})
      for (const double z : {box.low.z(), box.high.z()}) corners.push_back(out_of(Vec3(x, y, z)));
  return implicit::bounds(corners);
}

implicit::Field RimFrame::seen(const implicit::Field& field) const {
  return [this, &field](std::span<const Vec3> places, std::span<double> values, std::span<Vec3> gradients) {
    field(out_of(places), values, gradients);
    for (Vec3& gradient : gradients) gradient = axes_ * gradient;
  };
}

}  // namespace croquis::hole_filling
