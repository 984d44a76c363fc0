// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_pane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace croquis::app {
namespace {

constexpr double radians_per_pixel = 0.008;
constexpr double first_height = 640;  // sketch units
constexpr double frame_margin = 0.1;
constexpr double least_share = 0.5;                  // of the view: a scene that fills less is framed again
constexpr std::size_t most_framed_points = 200'000;  // of more, only the box is framed: views must not wait

std::vector<glm::dvec3> framing_points(const render::Scene& scene) {
  std::size_t count = 0;
  for (const auto& mesh : scene.meshes) count += mesh.item ? mesh.item->vertices.size() : 0;
  if (count <= most_framed_points) return render::points_of(scene);
  const render::Bounds bounds = render::bounds_of(scene);
  if (bounds.empty()) return {};
  const auto corners = bounds.corners();
  return {corners.begin(), corners.end()};
}

Eigen::Matrix4d eigen_matrix(const glm::dmat4& matrix) {
  Eigen::Matrix4d result;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) result(row, column) = matrix[column][row];
  }
  return result;
}

}  // namespace

SketchFrame ViewPane::sketch_frame() const {
  const double units = camera.height / std::max(rect.height(), 1.0);
  const Vec2 half(rect.width() / 2 * units, -camera.height / 2);
  return {Vec2(camera.target.x, camera.target.y) - half, units};
}

ViewFrame ViewPane::view_frame(const render::Bounds& bounds) const {
  const render::DepthRange range = render::depth_range(camera, bounds);
  const double aspect = visible() ? rect.width() / rect.height() : 1;
  const glm::dmat4 to_clip = render::projection_matrix(camera, aspect, range) * render::view_matrix(camera);
  return ViewFrame::of(eigen_matrix(to_clip), Vec2(std::max(rect.width(), 1.0), std::max(rect.height(), 1.0)));
}

void ViewPane::move(const CameraMotion& motion) {
  if (!visible()) return;
  const glm::dvec2 pixels(motion.delta.x(), motion.delta.y());
  switch (motion.kind) {
    case CameraMotion::Kind::Tumble: camera = render::tumble(camera, camera.target, pixels * radians_per_pixel); break;
    case CameraMotion::Kind::Track: camera = render::track(camera, pixels, rect.height()); break;
    case CameraMotion::Kind::Dolly:
      camera = flat()
                   ? render::dolly_about(camera, motion.factor, glm::dvec2(motion.about.x(), motion.about.y()), size())
                   : render::dolly(camera, motion.factor);
      break;
  }
}

void ViewPane::turn_to(const Vec3& facing) {
  constexpr double steep = 0.5, upright = 0.95;  // cosines
  const glm::dvec3 front(facing.x(), facing.y(), facing.z());
  const double distance = glm::length(camera.eye - camera.target);
  const glm::dvec3 to_eye = (camera.eye - camera.target) / distance;
  if (flat() || glm::dot(front, to_eye) >= steep) return;
  const glm::dvec3 up = glm::normalize(camera.up);
  // From straight above or below a little of where the eye was is kept: up has to stay up.
  const glm::dvec3 aside = to_eye - glm::dot(to_eye, up) * up;
  const bool is_upright = std::abs(glm::dot(front, up)) > upright && glm::length(aside) > 0;
  const glm::dvec3 seen_from = is_upright ? glm::normalize(front + 0.5 * glm::normalize(aside)) : front;
  camera.eye = camera.target + distance * seen_from;
}

void ViewPane::frame(const render::Bounds& bounds) {
  if (!visible() || bounds.empty()) return;
  const render::ViewDirection direction =
      flat() ? render::view_direction(kind)
             : render::ViewDirection{camera.target - camera.eye, camera.up, camera.projection};
  camera = render::frame(bounds, direction, rect.width() / rect.height(), frame_margin);
}

void ViewPane::frame(const render::Scene& scene) {
  const std::vector<glm::dvec3> points = framing_points(scene);
  if (!visible() || points.empty()) return;
  const render::ViewDirection direction{camera.target - camera.eye, camera.up, camera.projection};
  camera = render::frame(points, direction, rect.width() / rect.height(), frame_margin);
}

bool ViewPane::fits(const render::Scene& scene) const {
  if (!visible()) return true;
  // For scans of hundreds of thousands of points: matrices once, not for every point.
  const ViewFrame frame = view_frame(render::bounds_of(scene));
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (const glm::dvec3& point : framing_points(scene)) {
    const auto seen = frame.project({point.x, point.y, point.z});
    if (!seen) return false;
    low = low.cwiseMin(seen->pixel);
    high = high.cwiseMax(seen->pixel);
  }
  if (!(low.x() <= high.x())) return false;
  constexpr double half = 0.5;  // pixels
  const bool inside = low.minCoeff() >= half && high.x() <= rect.width() - half && high.y() <= rect.height() - half;
  const Vec2 extent = high - low;
  return inside && (extent.x() > least_share * rect.width() || extent.y() > least_share * rect.height());
}

ViewPane first_pane(render::NamedView kind) {
  ViewPane pane;
  pane.kind = kind;
  const render::Bounds about{{-200, -200, -200}, {200, 200, 200}};
  pane.camera = render::frame(about, render::view_direction(kind), 1);
  if (kind == render::NamedView::Front) pane.camera.eye = {0, 0, first_height};
  if (pane.flat()) pane.camera.height = first_height;
  return pane;
}

}  // namespace croquis::app
