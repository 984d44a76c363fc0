// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include "croquis/render/renderer.h"
#include "render/gl/gl_handle.h"
#include "render/gl/uploads.h"
#include "render/scene/view_frame.h"

namespace croquis::render {

/// What the passes of one drawing share.
struct Drawing {
  const Scene& scene;
  const RenderOptions& options;
  const PixelRect& viewport;
  ViewFrame view;  ///< of the surfaces' frame, border included
  int border = 0;  ///< pixels of it around the viewport
  int samples = 1;
  ScreenRect seen;  ///< where surfaces may be, pixels of that frame
  Uploads& uploads;

  /// Samples per pixel of the lengths in the options.
  double samples_per_pixel() const { return options.pixel_ratio * samples; }
};

/// Where lines and marks are drawn: exactly the viewport, a sample per pixel.
struct OverlayFrame {
  ViewFrame view;
  glm::vec2 size;                          ///< pixels
  const FrameBuffers* surfaces = nullptr;  ///< what may cover them; null for no surfaces
  int border = 0;                          ///< pixels of these around the viewport
  Uploads& uploads;
};

/// Lines and marks nearer to a perspective eye than this share of the target's distance are cut off: at the eye itself
/// there is no place on screen.
inline constexpr float nearest_overlay = 0.01F;

/// Whether hollows are darkened: a matter of light.
inline bool wants_occlusion(const RenderOptions& options) {
  return options.occlusion && options.shading == Shading::Clay;
}

/// Whether a mesh is drawn over the others, which it doesn't hide.
inline bool is_translucent(const Shown<MeshItem>& shown) {
  return shown.item && shown.style.surface == SurfaceLook::Filled && shown.style.opacity < 1;
}

/// Whether there is such a mesh.
bool has_veil(const Scene& scene);

inline glm::vec4 to_float(const Color& color) { return glm::vec4(color) / 255.0F; }

/// The colour of an emphasis; alpha 0 when there is none.
glm::vec4 emphasis_color(const EmphasisOptions& options, const Emphasis& emphasis);

class ShaderProgram;

/// Sets what visibility.glsl reads; the program must be in use.
void set_visibility(const ShaderProgram& program, const OverlayFrame& frame, bool depth_tested);

}  // namespace croquis::render
