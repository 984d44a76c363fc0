// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/camera/axis_signs.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace croquis {
namespace {

/// An axis that is seen shorter than this part of its length is judged by its direction in depth instead.
constexpr double least_seen = 1e-3;

/// How the picture moves along an axis at a place, per focal length: 1 where the axis lies across the view.
Vec2 seen_direction(const CameraParameters& camera, int axis, const Vec2& place) {
  const Vec3 point = camera.vanishing_point(axis);
  return (point.head<2>() - point.z() * place) / camera.focal();
}

}  // namespace

Eigen::Matrix3d signed_axes(const CameraParameters& camera, const Vec2& place, bool turn_round) {
  Eigen::Matrix3d axes = camera.rotation;
  const Vec2 up = seen_direction(camera, 2, place);
  const bool z_is_down = std::abs(up.y()) > least_seen ? up.y() > 0 : axes(2, 2) > 0;
  if (z_is_down) axes.col(2) = -axes.col(2);
  const Vec2 right = seen_direction(camera, 0, place);
  const bool x_is_left = std::abs(right.x()) > least_seen ? right.x() < 0 : axes(2, 0) < 0;
  if (x_is_left != turn_round) axes.col(0) = -axes.col(0);
  if (axes.determinant() < 0) axes.col(1) = -axes.col(1);
  return axes;
}

}  // namespace croquis
