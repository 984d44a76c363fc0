// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/frame_buffers.h"

#include <array>
#include <span>

#include <epoxy/gl.h>

namespace croquis::render {
namespace {

GlHandle make_target(std::span<const GlHandle* const> textures, const GlHandle* depth_buffer) {
  GlHandle target = make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, target.name());
  std::array<GLenum, 4> attachments = {};
  for (std::size_t i = 0; i < textures.size(); ++i) {
    attachments[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachments[i], GL_TEXTURE_2D, textures[i]->name(), 0);
  }
  if (depth_buffer != nullptr) {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_buffer->name());
  }
  glDrawBuffers(static_cast<GLsizei>(textures.size()), attachments.data());
  check_framebuffer();
  return target;
}

}  // namespace

FrameBuffers::FrameBuffers(const FrameSize& frame)
    : size(frame),
      colors(make_texture(GL_RGBA8, frame.width(), frame.height())),
      normals(make_texture(GL_RGBA16F, frame.width(), frame.height())),
      depths(make_texture(GL_RG32F, frame.width(), frame.height())),
      overlay(make_texture(GL_RGBA8, frame.width(), frame.height())),
      marks(make_texture(GL_R8, frame.width(), frame.height())),
      row_distances(make_texture(GL_R8, frame.width(), frame.height())),
      openness(make_texture(GL_R8, frame.pixel_width, frame.pixel_height)),
      depth_buffer(make_depth_buffer(frame.width(), frame.height())) {
  check_gl("making the buffers of a picture");
  surface_target = make_target(std::array<const GlHandle*, 3>{&colors, &normals, &depths}, &depth_buffer);
  overlay_target = make_target(std::array<const GlHandle*, 1>{&overlay}, &depth_buffer);
  marks_target = make_target(std::array<const GlHandle*, 1>{&marks}, nullptr);
  row_distances_target = make_target(std::array<const GlHandle*, 1>{&row_distances}, nullptr);
  openness_target = make_target(std::array<const GlHandle*, 1>{&openness}, nullptr);
}

void FrameBuffers::require_veil() {
  if (veil.name() != 0) return;
  veil = make_texture(GL_RGBA8, size.width(), size.height());
  check_gl("making the buffers of a picture");
  veil_target = make_target(std::array<const GlHandle*, 1>{&veil}, &depth_buffer);
}

}  // namespace croquis::render
