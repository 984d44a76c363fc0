// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/canvas.h"

#include <epoxy/gl.h>

namespace croquis::render {

void Canvas::begin(const glm::ivec2& size) {
  if (size.x > size_.x || size.y > size_.y) {
    size_ = glm::max(size_, size);
    color_ = make_texture(GL_RGBA8, size_.x, size_.y);
    depth_stencil_ = make_depth_stencil_buffer(size_.x, size_.y);
    framebuffer_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_stencil_.name());
    check_framebuffer();
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, size.x, size.y);
}

}  // namespace croquis::render
