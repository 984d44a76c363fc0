// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "croquis/render/bounds.h"
#include "croquis/render/renderer.h"

namespace croquis::render {

/// The geometry of one drawing, in units of the distance from the eye to the target: so the shaders meet the same
/// numbers whether a model is measured in microns or in miles.
struct ViewFrame {
  bool perspective = false;
  double unit = 1;           ///< model units per view unit
  glm::dmat4 model_to_view;  ///< of model coordinates
  glm::mat4 to_clip;
  glm::vec2 extent;          ///< half size of the drawn frame at distance 1
  glm::vec2 center;          ///< of the drawn frame at distance 1
  float picture_height = 0;  ///< of the whole picture at distance 1
  PictureCrop crop;          ///< always set: which part of which picture the viewport shows
};

/// From an item's own frame to view space.
template <typename Item>
glm::dmat4 item_to_view(const Item& item, const glm::dmat4& placement, const ViewFrame& view) {
  return glm::scale(glm::translate(view.model_to_view * placement, item.origin), glm::dvec3(item.scale));
}

template <typename Item>
glm::dmat4 item_to_view(const Shown<Item>& shown, const ViewFrame& view) {
  return item_to_view(*shown.item, shown.placement, view);
}

/// @param border pixels drawn around the viewport
ViewFrame make_view_frame(const Camera& camera, const Bounds& bounds, const PixelRect& viewport, int border);

/// Pixels of a frame from its lower left corner; `high` is outside.
struct ScreenRect {
  glm::ivec2 low = glm::ivec2(0);
  glm::ivec2 high = glm::ivec2(0);

  glm::ivec2 size() const { return glm::max(high - low, glm::ivec2(0)); }

  /// Larger by that many pixels on each side.
  ScreenRect grown(int pixels) const { return {low - pixels, high + pixels}; }
};

/// The part of the frame that the box can be seen in; all of it when the box reaches behind the eye.
/// @param size of the frame, pixels
ScreenRect seen_part(const Bounds& bounds, const ViewFrame& view, const glm::ivec2& size);

/// Restricts drawing to the part of the framebuffer where the rectangle lies.
/// @param origin where the frame's lower left corner lies in the framebuffer, pixels
/// @param samples of the framebuffer per pixel and axis
void set_scissor(const ScreenRect& rect, const glm::ivec2& origin, int samples);

}  // namespace croquis::render
