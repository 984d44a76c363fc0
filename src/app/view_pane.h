// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

#include "croquis/render/camera.h"
#include "croquis/render/camera_motion.h"
#include "croquis/render/scene.h"
#include "croquis/tools/navigation.h"
#include "croquis/tools/sketch_event.h"

namespace croquis::app {

/// One view of the window: a camera and the rectangle of the widget that it fills.
struct ViewPane {
  render::Camera camera;
  QRectF rect;        ///< logical pixels of the widget, y down; empty while hidden
  bool flat = false;  ///< looks along -z and never turns

  glm::dvec2 size() const { return {rect.width(), rect.height()}; }
  bool visible() const { return rect.width() >= 1 && rect.height() >= 1; }

  /// Of a flat view.
  SketchFrame sketch_frame() const;

  void move(const CameraMotion& motion);

  /// The whole scene is seen, and not much smaller than it could be.
  bool fits(const render::Scene& scene) const;

  /// Shows the box; the whole of a scene of surfaces as close as it fits.
  void frame(const render::Bounds& bounds);
  void frame(const render::Scene& scene);
};

/// The sketch view of a new sketch: one unit a pixel.
ViewPane sketch_pane();
ViewPane perspective_pane();

}  // namespace croquis::app
