// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

#include "croquis/render/camera.h"
#include "croquis/render/camera_motion.h"
#include "croquis/render/scene.h"
#include "croquis/tools/pointer/navigation.h"
#include "croquis/tools/pointer/view_frame.h"
#include "croquis/tools/strokes/sketch_event.h"

namespace croquis::app {

/// The views of the window, by their places in lists.
enum View { SketchView = 0, PerspectiveView = 1, TopView = 2, SideView = 3, ComparisonView = 4 };
inline constexpr int view_count = 5;

/// One view of the window: a camera and the rectangle of the widget that it fills.
struct ViewPane {
  render::NamedView kind = render::NamedView::Perspective;
  render::Camera camera;
  QRectF rect;  ///< logical pixels of the widget, y down; empty while hidden

  bool flat() const { return kind != render::NamedView::Perspective; }  ///< never rotates
  glm::dvec2 size() const { return {rect.width(), rect.height()}; }
  bool visible() const { return rect.width() >= 1 && rect.height() >= 1; }

  /// Of the view that looks along -z.
  SketchFrame sketch_frame() const;

  /// How tools see the model. @param bounds of what is to lie between the near and the far plane
  ViewFrame view_frame(const render::Bounds& bounds) const;

  void move(const CameraMotion& motion);

  /// The whole scene is seen, and not much smaller than it could be.
  bool fits(const render::Scene& scene) const;

  /// Where what faces that way (unit) is seen too much from the side or from behind, looks at it from its front.
  void turn_to(const Vec3& facing);

  /// Shows the box; the whole of a scene as close as it fits.
  void frame(const render::Bounds& bounds);
  void frame(const render::Scene& scene);
};

/// The view as it is before anything is framed: flat ones show one unit a pixel.
ViewPane first_pane(render::NamedView kind);

}  // namespace croquis::app
