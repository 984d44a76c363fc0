// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/gl_handle.h"

#include <array>

#include <epoxy/gl.h>

#include "croquis/base/error.h"

namespace croquis::render {
namespace {

const char* error_name(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM: return "invalid enum";
    case GL_INVALID_VALUE: return "invalid value";
    case GL_INVALID_OPERATION: return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "invalid framebuffer operation";
    case GL_OUT_OF_MEMORY: return "out of memory";
    default: return "unknown error";
  }
}

GlHandle make_renderbuffer(GLenum format, int width, int height) {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  GlHandle handle(name, [](unsigned buffer) { glDeleteRenderbuffers(1, &buffer); });
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  return handle;
}

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

GlHandle make_buffer() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return {name, [](unsigned buffer) { glDeleteBuffers(1, &buffer); }};
}

GlHandle make_vertex_array() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return {name, [](unsigned array) { glDeleteVertexArrays(1, &array); }};
}

GlHandle make_framebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  return {name, [](unsigned framebuffer) { glDeleteFramebuffers(1, &framebuffer); }};
}

GlHandle make_depth_buffer(int width, int height) { return make_renderbuffer(GL_DEPTH_COMPONENT24, width, height); }

GlHandle make_depth_stencil_buffer(int width, int height) {
  return make_renderbuffer(GL_DEPTH24_STENCIL8, width, height);
}

GlHandle upload(unsigned target, std::span<const std::byte> bytes) {
  GlHandle buffer = make_buffer();
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  return buffer;
}

GlHandle make_texture(unsigned format, int width, int height) {
  GLuint name = 0;
  glGenTextures(1, &name);
  GlHandle handle(name, [](unsigned texture) { glDeleteTextures(1, &texture); });
  glBindTexture(GL_TEXTURE_2D, name);
  // Format and type describe data that is not given; any pair that fits a colour format will do.
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
  return handle;
}

void throw_gl_error(const std::string& message) { throw Error(make_error(Category::Internal, "E_GL", message)); }

void check_gl(std::string_view doing) {
  std::string errors;
  // A lost context reports errors without end: a few are enough to know.
  for (int i = 0; i < 8; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    errors += std::string(errors.empty() ? "" : ", ") + error_name(error);
  }
  if (!errors.empty()) throw_gl_error("OpenGL failed while " + std::string(doing) + ": " + errors + ".");
}

void check_framebuffer() {
  const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw_gl_error("OpenGL can't draw into the framebuffer (status " + std::to_string(status) + ").");
}

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
