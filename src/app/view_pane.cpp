// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view_pane.h"

#include <algorithm>

namespace croquis::app {
namespace {

constexpr double radians_per_pixel = 0.008;
constexpr double first_height = 640;  // sketch units
constexpr double margin = 0.1;
constexpr double least_share = 0.5;  // of the view: a scene that fills less is framed anew

}  // namespace

SketchFrame ViewPane::sketch_frame() const {
  const double units = camera.height / std::max(rect.height(), 1.0);
  const Vec2 half(rect.width() / 2 * units, -camera.height / 2);
  return {Vec2(camera.target.x, camera.target.y) - half, units};
}

void ViewPane::move(const CameraMotion& motion) {
  if (!visible()) return;
  const glm::dvec2 pixels(motion.delta.x(), motion.delta.y());
  switch (motion.kind) {
    case CameraMotion::Kind::Tumble: camera = render::tumble(camera, camera.target, pixels * radians_per_pixel); break;
    case CameraMotion::Kind::Track: camera = render::track(camera, pixels, rect.height()); break;
    case CameraMotion::Kind::Dolly:
      camera = flat ? render::dolly_about(camera, motion.factor, glm::dvec2(motion.about.x(), motion.about.y()), size())
                    : render::dolly(camera, motion.factor);
      break;
  }
}

void ViewPane::frame(const render::Bounds& bounds) {
  if (!visible() || bounds.empty()) return;
  const render::ViewDirection direction =
      flat ? render::view_direction(render::NamedView::Front)
           : render::ViewDirection{camera.target - camera.eye, camera.up, camera.projection};
  camera = render::frame(bounds, direction, rect.width() / rect.height(), margin);
}

void ViewPane::frame(const render::Scene& scene) {
  const std::vector<glm::dvec3> points = render::points_of(scene);
  if (!visible() || points.empty()) return;
  const render::ViewDirection direction{camera.target - camera.eye, camera.up, camera.projection};
  camera = render::frame(points, direction, rect.width() / rect.height(), margin);
}

bool ViewPane::fits(const render::Scene& scene) const {
  if (!visible()) return true;
  QRectF seen;
  for (const glm::dvec3& point : render::points_of(scene)) {
    const auto pixel = render::project(camera, point, size());
    if (!pixel) return false;
    const QRectF place(pixel->x - 0.5, pixel->y - 0.5, 1, 1);
    seen = seen.isNull() ? place : seen.united(place);
  }
  const QRectF inside(0, 0, rect.width(), rect.height());
  const bool large = seen.width() > least_share * rect.width() || seen.height() > least_share * rect.height();
  return inside.contains(seen) && large;
}

ViewPane sketch_pane() {
  ViewPane pane;
  pane.flat = true;
  pane.camera.eye = {0, 0, first_height};
  pane.camera.height = first_height;
  return pane;
}

ViewPane perspective_pane() {
  ViewPane pane;
  const render::Bounds about{{-200, -200, -200}, {200, 200, 200}};
  pane.camera = render::frame(about, render::view_direction(render::NamedView::Perspective), 1);
  return pane;
}

}  // namespace croquis::app
