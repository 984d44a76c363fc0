// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "app/views/view_pane.h"
#include "croquis/geometry/camera.h"

namespace croquis::app {

/// A camera that some step of an object gives: views can be held at it.
struct SceneCamera {
  NodeId node = 0;             ///< the first one of the object's chain
  QString name;                ///< of the object
  Camera camera;               ///< in the space of the views
  Vec2 origin = Vec2::Zero();  ///< upper left corner of its picture, px
  double depth = 1;            ///< before the eye, of the middle of what was found; > 0

  /// The view's camera that shows the whole picture as large as it fits into the pane, with whatever lies before it.
  render::Camera in(const ViewPane& pane) const;

  /// A place of the picture at that depth before the eye.
  glm::dvec3 before_the_eye(const Vec2& place) const;
};

/// Of all objects, in their order.
std::vector<SceneCamera> scene_cameras(const Studio& studio);

/// Of the object that begins with that node.
std::optional<SceneCamera> scene_camera(const Studio& studio, NodeId first);

}  // namespace croquis::app
