// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/look_through.h"

#include <algorithm>
#include <cmath>

namespace croquis::app {
namespace {

constexpr double sheet_share = 0.96;  // of the pane

glm::dvec3 glm_place(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

render::Camera camera_through(const Camera& camera, const PerspectiveDrawing& drawing, const Affine3& placement,
                              double depth, const ViewPane& pane) {
  const double scale =
      sheet_share * std::min(pane.rect.width() / drawing.image_size.x(), pane.rect.height() / drawing.image_size.y());
  const double height = pane.rect.height() / scale;  // of the pane, px of the sheet
  const Vec3 forward = camera.rotation.row(2).transpose();
  const Vec3 up = -camera.rotation.row(1).transpose();
  const Vec2 offset = camera.principal_point - drawing.centre();
  render::Camera through;
  through.projection = render::Projection::Perspective;
  through.eye = glm_place(placement(camera.eye));
  through.target = glm_place(placement(camera.eye + depth * forward));
  through.up = glm_place(placement(camera.eye + up) - placement(camera.eye));
  through.field_of_view = 2 * std::atan(height / (2 * camera.focal_length));
  through.principal_offset = {offset.x() / height, -offset.y() / height};
  return through;
}

glm::dvec3 before_the_eye(const Camera& camera, const Affine3& placement, const Vec2& sheet, double depth) {
  return glm_place(placement(camera.eye + depth * camera.ray(sheet)));
}

}  // namespace croquis::app
