// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/perspective/views.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace croquis::test {
namespace {

Eigen::AlignedBox3d bounds_in_space(const PerspectiveSolid& solid) {
  Eigen::AlignedBox3d box;
  for (const NetworkCurve& curve : solid.network.curves) {
    for (const RationalCubic& piece : curve.pieces) {
      for (const Vec3& point : piece.points) box.extend(point);
    }
  }
  return box;
}

Eigen::AlignedBox2d bounds_in_picture(const PerspectiveSolid& solid, const Camera& camera) {
  Eigen::AlignedBox2d box;
  for (const NetworkCurve& curve : solid.network.curves) {
    for (const RationalCubic& piece : curve.pieces) {
      for (const Vec3& point : piece.points) box.extend(camera.project(point));
    }
  }
  return box;
}

Eigen::Matrix3d rotation_of(const View& view) {
  const double sa = std::sin(view.azimuth), ca = std::cos(view.azimuth);
  const double se = std::sin(view.elevation), ce = std::cos(view.elevation);
  Eigen::Matrix3d rotation;
  rotation.row(0) << ca, sa, 0;
  rotation.row(1) << se * sa, -se * ca, -ce;
  rotation.row(2) << -ce * sa, ce * ca, -se;
  return rotation;
}

}  // namespace

Camera camera_for(const PerspectiveSolid& solid, const View& view) {
  const Vec2 sheet_centre = view.origin + view.image_size / 2;
  Camera camera;
  camera.image_origin = view.origin;
  camera.image_size = view.image_size;
  camera.focal_length = view.image_size.x() / 2 / std::tan(view.field_of_view / 2);
  camera.principal_point = sheet_centre + view.principal_offset.cwiseProduct(view.image_size);
  camera.rotation = rotation_of(view);
  const Eigen::AlignedBox3d space = bounds_in_space(solid);
  const Vec2 wanted = sheet_centre + view.placement.cwiseProduct(view.image_size);
  const Eigen::Matrix3d& r = camera.rotation;
  double distance = 3 * space.diagonal().norm();
  Vec3 aim = space.center();
  // Moving the camera sideways moves the picture by about f / distance, and its size goes with 1 / distance.
  for (int round = 0; round < 60; ++round) {
    const Vec2 sideways = (wanted - camera.principal_point) * distance / camera.focal_length;
    camera.eye = aim - r.transpose() * Vec3(sideways.x(), sideways.y(), distance);
    const Eigen::AlignedBox2d seen = bounds_in_picture(solid, camera);
    const Vec2 miss = (seen.center() - wanted) * distance / camera.focal_length;
    aim += r.transpose() * Vec3(miss.x(), miss.y(), 0);
    const double filled = seen.sizes().cwiseQuotient(view.fill * view.image_size).maxCoeff();
    distance = std::max(distance * (1 + 0.7 * (filled - 1)), 0.8 * space.diagonal().norm());
  }
  return camera;
}

std::vector<View> three_point_views() {
  std::vector<View> views;
  for (const int degrees : {25, 50, 80}) {
    View view;
    view.name = "field of view " + std::to_string(degrees);
    view.field_of_view = degrees * std::numbers::pi / 180;
    views.push_back(view);
  }
  return views;
}

View level_view() {
  View view;
  view.name = "level";
  view.elevation = 0;
  view.azimuth = 25 * std::numbers::pi / 180;
  view.placement = {0, 0.12};
  view.fill = 0.65;
  return view;
}

View frontal_view() {
  View view;
  view.name = "frontal";
  view.azimuth = view.elevation = 0;
  view.field_of_view = 65 * std::numbers::pi / 180;
  view.placement = {-0.27, 0.28};
  view.fill = 0.42;
  return view;
}

View off_centre_view() {
  View view;
  view.name = "off centre";
  view.principal_offset = {0.12, -0.05};
  return view;
}

View cropped_view() {
  View view;
  view.name = "cropped";
  view.origin = {240, 130};
  view.image_size = {620, 480};
  view.principal_offset = {-0.3, 0.22};
  view.fill = 0.9;
  return view;
}

std::vector<View> all_views() {
  std::vector<View> views = three_point_views();
  for (const View& view : {level_view(), frontal_view(), off_centre_view(), cropped_view()}) views.push_back(view);
  return views;
}

}  // namespace croquis::test
