// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/camera.h"

namespace croquis {

Vec2 Camera::project(const Vec3& point) const {
  const Vec3 seen = rotation * (point - eye);
  return principal_point + focal_length / seen.z() * seen.head<2>();
}

Vec3 Camera::ray(const Vec2& place) const {
  const Vec2 sideways = (place - principal_point) / focal_length;
  return rotation.transpose() * Vec3(sideways.x(), sideways.y(), 1);
}

Vec3 Camera::vanishing_point(int axis) const {
  const Vec3 direction = rotation.col(axis);
  Vec3 point;
  point << focal_length * direction.head<2>() + principal_point * direction.z(), direction.z();
  return point;
}

}  // namespace croquis
