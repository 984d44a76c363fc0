// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "croquis/geometry/vector.h"
#include "croquis/render/camera.h"
#include "croquis/render/color.h"

namespace croquis::app {

/// A colour of the theme for the renderer, as opaque as asked (0..255).
inline render::Color to_color(const QColor& color, int alpha = 255) {
  return {color.red(), color.green(), color.blue(), alpha};
}

/// The same with the opacity that the colour has itself.
inline render::Color with_own_alpha(const QColor& color) { return to_color(color, color.alpha()); }

/// How wide lines of sketches are, logical pixels.
inline constexpr double ink_width = 2.2;

/// A place for the renderer.
inline glm::dvec3 to_glm(const Vec3& place) { return {place.x(), place.y(), place.z()}; }

}  // namespace croquis::app
