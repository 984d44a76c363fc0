// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/camera.h"

#include <Eigen/SVD>

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

Camera transformed(const Camera& camera, const Affine3& map) {
  if (map.is_identity()) return camera;
  const Eigen::JacobiSVD<Eigen::Matrix3d> parts(map.linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d turn = parts.matrixU() * parts.matrixV().transpose();
  if (turn.determinant() < 0) {  // mirrored: turned about the direction that is scaled least instead
    turn -= 2 * parts.matrixU().col(2) * parts.matrixV().col(2).transpose();
  }
  Camera result = camera;
  result.eye = map(camera.eye);
  result.rotation = camera.rotation * turn.transpose();
  return result;
}

}  // namespace croquis
