// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/scene_camera.h"

#include <algorithm>
#include <cmath>

#include "app/panels/object_names.h"

namespace croquis::app {
namespace {

constexpr double picture_share = 0.96;  // of the pane

glm::dvec3 glm_vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// What a result says, or null.
std::shared_ptr<const Camera> camera_of(const Evaluation& result) {
  for (const auto& [port, value] : result.outputs) {
    if (auto camera = value.as<Camera>(); camera && camera->image_size.minCoeff() > 0) return camera;
  }
  return nullptr;
}

/// Of the middle of what a result holds.
double depth_in(const Evaluation& result, const Camera& camera) {
  for (const auto& [port, value] : result.outputs) {
    const BoundingBox box = bounds_of(value);
    const double depth = box ? camera.depth(((*box)[0] + (*box)[1]) / 2) : 0;
    if (depth > 0) return depth;
  }
  return 1;
}

std::optional<SceneCamera> camera_in(const Studio& studio, const WorkObject& object) {
  for (const NodeId step : object.chain) {
    // Held here: results are computed and forgotten on other threads meanwhile.
    const auto result = studio.result(step);
    const auto camera = result ? camera_of(*result) : nullptr;
    if (!camera) continue;
    SceneCamera found;
    found.node = object.chain.front();
    found.name = shown_name(object);
    const Affine3 to_model = object.placement.map();
    found.camera = Value(camera).transformed(to_model).get<Camera>();
    const auto sheet = source_of<PerspectiveDrawing>(studio.session().document().find(found.node));
    if (sheet) found.origin = sheet->origin;
    found.depth = depth_in(*result, *camera) * std::cbrt(object.placement.scale.prod());
    return found;
  }
  return std::nullopt;
}

}  // namespace

render::Camera SceneCamera::in(const ViewPane& pane) const {
  const double scale =
      picture_share * std::min(pane.rect.width() / camera.image_size.x(), pane.rect.height() / camera.image_size.y());
  const double height = pane.rect.height() / scale;  // of the pane, px of the picture
  const Vec2 offset = camera.principal_point - (origin + camera.image_size / 2);
  render::Camera through;
  through.projection = render::Projection::Perspective;
  through.eye = glm_vector(camera.eye);
  through.target = glm_vector(camera.eye + depth * camera.rotation.row(2).transpose());
  through.up = glm_vector(-camera.rotation.row(1).transpose());
  through.field_of_view = 2 * std::atan(height / (2 * camera.focal_length));
  through.principal_offset = {offset.x() / height, -offset.y() / height};
  return through;
}

glm::dvec3 SceneCamera::before_the_eye(const Vec2& place) const {
  return glm_vector(camera.eye + depth * camera.ray(place));
}

std::vector<SceneCamera> scene_cameras(const Studio& studio) {
  std::vector<SceneCamera> cameras;
  for (const WorkObject& object : studio.objects()) {
    if (auto camera = camera_in(studio, object)) cameras.push_back(*std::move(camera));
  }
  return cameras;
}

std::optional<SceneCamera> scene_camera(const Studio& studio, NodeId first) {
  for (const WorkObject& object : studio.objects()) {
    if (object.chain.front() != first) continue;
    if (auto camera = camera_in(studio, object)) return camera;
  }
  return std::nullopt;
}

}  // namespace croquis::app
