// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/pointer/view_frame.h"

#include <Eigen/LU>

namespace croquis {
namespace {

Eigen::Vector4d homogeneous(const Vec3& place) { return {place.x(), place.y(), place.z(), 1}; }

/// A unit vector, or the other one where there is none.
Vec3 unit_or(const Vec3& vector, const Vec3& otherwise) {
  const double length = vector.norm();
  return length > 0 ? Vec3(vector / length) : otherwise;
}

/// What projects to x = y = w = 0: a direction (w = 0) in parallel views.
Eigen::Vector4d eye_of(const ViewFrame& frame) { return frame.from_clip * Eigen::Vector4d(0, 0, -1, 0); }

}  // namespace

ViewFrame ViewFrame::of(const Eigen::Matrix4d& to_clip, const Vec2& size) { return {to_clip, to_clip.inverse(), size}; }

Vec3 ViewFrame::unproject(const Vec2& pixel, double depth) const {
  const Eigen::Vector4d at(2 * pixel.x() / size.x() - 1, 1 - 2 * pixel.y() / size.y(), depth, 1);
  const Eigen::Vector4d place = from_clip * at;
  return place.head<3>() / place.w();
}

Ray ViewFrame::ray(const Vec2& pixel) const {
  const Vec3 origin = unproject(pixel, -1);
  return {origin, unit_or(unproject(pixel, 1) - origin, -Vec3::UnitZ())};
}

Ray ViewFrame::sight(const Vec2& pixel) const {
  Ray sight = ray(pixel);
  if (perspective()) {
    const Eigen::Vector4d eye = eye_of(*this);
    sight.origin = eye.head<3>() / eye.w();
  }
  return sight;
}

std::optional<Projected> ViewFrame::project(const Vec3& place) const {
  const Eigen::Vector4d clip = to_clip * homogeneous(place);
  if (!(clip.w() > 0)) return std::nullopt;
  const Vec3 at = clip.head<3>() / clip.w();
  return Projected{{(at.x() + 1) / 2 * size.x(), (1 - at.y()) / 2 * size.y()}, at.z()};
}

double ViewFrame::units_per_pixel(const Vec3& place) const {
  const auto at = project(place);
  if (!at) return 0;
  // Places of equal depth lie in a plane across the view, in which all pixels are equally long.
  return (unproject(at->pixel + Vec2(1, 0), at->depth) - unproject(at->pixel, at->depth)).norm();
}

Vec3 ViewFrame::to_eye(const Vec3& place) const {
  const Eigen::Vector4d eye = eye_of(*this);
  return unit_or(eye.head<3>() - eye.w() * place, Vec3::UnitZ());
}

Vec3 ViewFrame::right() const {
  const Vec2 middle = size / 2;
  return unit_or(unproject(middle + Vec2(1, 0), 0) - unproject(middle, 0), Vec3::UnitX());
}

Vec3 ViewFrame::up() const {
  const Vec2 middle = size / 2;
  return unit_or(unproject(middle - Vec2(0, 1), 0) - unproject(middle, 0), Vec3::UnitY());
}

}  // namespace croquis
