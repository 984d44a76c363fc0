// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene/screen_rect.h"

#include <epoxy/gl.h>

namespace croquis::render {

ScreenRect seen_part(const Bounds& bounds, const ViewFrame& view, const glm::ivec2& size) {
  const ScreenRect everything{glm::ivec2(0), size};
  if (bounds.empty()) return {};
  const glm::dmat4 to_clip = glm::dmat4(view.to_clip) * view.model_to_view;
  glm::dvec2 low(1), high(-1);  // a share of the frame, whose half size is 1
  for (const glm::dvec3& corner : bounds.corners()) {
    const glm::dvec4 clip = to_clip * glm::dvec4(corner, 1);
    if (clip.w < 1e-6) return everything;
    low = glm::min(low, glm::dvec2(clip) / clip.w);
    high = glm::max(high, glm::dvec2(clip) / clip.w);
  }
  low = glm::clamp(low, -1.0, 1.0);
  high = glm::clamp(high, -1.0, 1.0);
  const glm::dvec2 half = 0.5 * glm::dvec2(size);
  return {glm::ivec2(glm::floor((low + 1.0) * half)), glm::ivec2(glm::ceil((high + 1.0) * half))};
}

void set_scissor(const ScreenRect& rect, const glm::ivec2& origin, int samples) {
  const glm::ivec2 low = (rect.low + origin) * samples;
  const glm::ivec2 size = rect.size() * samples;
  glEnable(GL_SCISSOR_TEST);
  glScissor(low.x, low.y, size.x, size.y);
}

}  // namespace croquis::render
