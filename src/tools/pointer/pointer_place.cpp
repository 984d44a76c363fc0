// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/pointer/pointer_place.h"

#include <algorithm>
#include <cmath>

namespace croquis {
namespace {

constexpr double least_looks = 0.01;  // how much smaller things may come to look towards the horizon

/// A clip position as pixels, y down, that are still to be divided by its w.
Vec2 undivided_pixel(const ViewFrame& frame, const Eigen::Vector4d& clip) {
  return Vec2(clip.x(), -clip.y()).cwiseProduct(frame.size / 2);
}

}  // namespace

double pointer_on_axis(const ViewFrame& frame, const Vec2& pixel, const Vec3& place, const Vec3& axis) {
  const auto seen = frame.project(place);
  if (!seen) return 0;
  const Eigen::Vector4d start = frame.to_clip.leftCols<3>() * place + frame.to_clip.col(3);
  const Eigen::Vector4d step = frame.to_clip.leftCols<3>() * axis;
  // On the screen the place t along the axis is t · way / (w (w + t step.w)) away from the start.
  const Vec2 way = undivided_pixel(frame, step) * start.w() - undivided_pixel(frame, start) * step.w();
  const double length = way.norm();
  if (!(length > 0)) return 0;
  const double pulled = (pixel - seen->pixel).dot(way) / length;
  const double looks = 1 - pulled * start.w() * step.w() / length;  // w / (w + t step.w)
  const double nearest_horizon = looks < least_looks ? (1 - least_looks) / (1 - looks) : 1;
  return nearest_horizon * pulled * start.w() * start.w() / (length * std::max(looks, least_looks));
}

std::optional<Vec3> pointer_on_plane(const ViewFrame& frame, const Vec2& pixel, const Vec3& place, const Vec3& normal) {
  const auto seen = frame.project(place);
  if (!seen) return std::nullopt;
  const auto met = [&](const Vec2& at) -> std::optional<Vec3> {
    const Ray sight = frame.sight(at);
    const double distance = (place - sight.origin).dot(normal) / sight.direction.dot(normal);
    if (!std::isfinite(distance)) return std::nullopt;
    return sight.at(distance);
  };
  if (!frame.perspective()) return met(pixel);
  const Ray sight = frame.sight(pixel);
  const Eigen::RowVector4d depth = frame.to_clip.row(3);
  const double away = (place - sight.origin).dot(normal);
  if (away == 0) return std::nullopt;
  // Over a plane, 1 / w changes evenly along the screen: up to the horizon, where it is 0.
  const double looks = (depth.head<3>().dot(place) + depth[3]) * sight.direction.dot(normal) /
                       (away * depth.head<3>().dot(sight.direction));
  if (looks >= least_looks) return met(pixel);
  return met(seen->pixel + (1 - least_looks) / (1 - looks) * (pixel - seen->pixel));
}

}  // namespace croquis
