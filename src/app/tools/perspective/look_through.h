// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/views/view_pane.h"
#include "croquis/geometry/affine3.h"
#include "croquis/geometry/camera.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/render/camera.h"

/// Seeing a solid from the eye that its drawing was seen from.
namespace croquis::app {

/// The view's camera that shows the sheet as large as it fits into the pane: what was drawn lies where it was drawn.
/// @param placement from the drawing's space to the view's; rigid
/// @param depth of what is looked at, > 0
render::Camera camera_through(const Camera& camera, const PerspectiveDrawing& drawing, const Affine3& placement,
                              double depth, const ViewPane& pane);

/// A place of the sheet at that depth before the eye, in the view's space.
glm::dvec3 before_the_eye(const Camera& camera, const Affine3& placement, const Vec2& sheet, double depth);

}  // namespace croquis::app
