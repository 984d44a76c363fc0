// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene/view_frame.h"

#include <cmath>

#include <epoxy/gl.h>

namespace croquis::render {

ViewFrame make_view_frame(const Camera& camera, const Bounds& bounds, const PixelRect& viewport, int border) {
  ViewFrame frame;
  frame.perspective = camera.projection == Projection::Perspective;
  frame.unit = glm::distance(camera.eye, camera.target);
  frame.crop = viewport.crop.value_or(PictureCrop{viewport.width, viewport.height, 0, 0});
  const glm::dvec2 picture(frame.crop.picture_width, frame.crop.picture_height);
  const double aspect = picture.x / picture.y;

  // The drawn frame as a share of the picture, whose half size is 1.
  const glm::dvec2 viewport_size(viewport.width, viewport.height);
  const glm::dvec2 corner(frame.crop.left, frame.crop.bottom);
  const glm::dvec2 middle = 2.0 * (corner + 0.5 * viewport_size) / picture - 1.0;
  const glm::dvec2 share = (viewport_size + 2.0 * border) / picture;
  const double half_height = frame.perspective ? std::tan(camera.field_of_view / 2) : 0.5 * camera.height / frame.unit;
  const glm::dvec2 half(half_height * aspect, half_height);
  frame.extent = glm::vec2(share * half);
  frame.center = glm::vec2(middle * half - 2 * half_height * camera.principal_offset);
  frame.picture_height = static_cast<float>(2 * half_height);

  const glm::dmat4 one(1);
  frame.model_to_view = glm::scale(one, glm::dvec3(1 / frame.unit)) * view_matrix(camera);
  const glm::dmat4 cut = glm::scale(one, glm::dvec3(1.0 / share, 1)) * glm::translate(one, glm::dvec3(-middle, 0));
  const glm::dmat4 projection = projection_matrix(camera, aspect, depth_range(camera, bounds));
  const glm::dmat4 to_clip = cut * projection * glm::scale(one, glm::dvec3(frame.unit));
  frame.to_clip = glm::mat4(to_clip / (frame.perspective ? frame.unit : 1.0));
  return frame;
}

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
