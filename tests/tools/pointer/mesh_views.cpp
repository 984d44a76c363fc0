// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/pointer/mesh_views.h"

#include <Eigen/Geometry>

namespace croquis::test {

Vec3 TestCamera::forward() const { return (target - eye).normalized(); }
Vec3 TestCamera::right() const { return forward().cross(up).normalized(); }
Vec3 TestCamera::upward() const { return right().cross(forward()); }

ViewFrame TestCamera::frame() const {
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.block<1, 3>(0, 0) = right().transpose();
  view.block<1, 3>(1, 0) = upward().transpose();
  view.block<1, 3>(2, 0) = -forward().transpose();
  view.block<3, 1>(0, 3) = -view.block<3, 3>(0, 0) * eye;
  const double aspect = size.x() / size.y();
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip(0, 0) = 1 / (half_height * aspect);
  clip(1, 1) = 1 / half_height;
  if (perspective) {
    clip(2, 2) = (far + near) / (near - far);
    clip(2, 3) = 2 * far * near / (near - far);
    clip(3, 2) = -1;
  } else {
    clip(2, 2) = 2 / (near - far);
    clip(2, 3) = (far + near) / (near - far);
    clip(3, 3) = 1;
  }
  return ViewFrame::of(clip * view, size);
}

Vec2 TestCamera::pixel_of(const Vec3& place) const {
  const Vec3 offset = place - eye;
  const double distance = perspective ? offset.dot(forward()) : 1;
  const double pixels_per_unit = size.y() / 2 / (half_height * distance);
  return size / 2 + pixels_per_unit * Vec2(offset.dot(right()), -offset.dot(upward()));
}

}  // namespace croquis::test
