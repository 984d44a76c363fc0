// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include "croquis/render/bounds.h"
#include "render/scene/view_frame.h"

namespace croquis::render {

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
