// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/host_state.h"

#include <epoxy/gl.h>

namespace croquis::render {
namespace {

constexpr std::array<GLenum, 9> switches = {GL_BLEND,
                                            GL_CULL_FACE,
                                            GL_DEPTH_TEST,
                                            GL_SCISSOR_TEST,
                                            GL_STENCIL_TEST,
                                            GL_POLYGON_OFFSET_FILL,
                                            GL_MULTISAMPLE,
                                            GL_SAMPLE_ALPHA_TO_COVERAGE,
                                            GL_PROGRAM_POINT_SIZE};

constexpr std::array<GLenum, 6> blend_names = {GL_BLEND_SRC_RGB,   GL_BLEND_DST_RGB,      GL_BLEND_SRC_ALPHA,
                                               GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};

constexpr std::array<GLenum, 14> stencil_names = {GL_STENCIL_FUNC,
                                                  GL_STENCIL_REF,
                                                  GL_STENCIL_VALUE_MASK,
                                                  GL_STENCIL_FAIL,
                                                  GL_STENCIL_PASS_DEPTH_FAIL,
                                                  GL_STENCIL_PASS_DEPTH_PASS,
                                                  GL_STENCIL_WRITEMASK,
                                                  GL_STENCIL_BACK_FUNC,
                                                  GL_STENCIL_BACK_REF,
                                                  GL_STENCIL_BACK_VALUE_MASK,
                                                  GL_STENCIL_BACK_FAIL,
                                                  GL_STENCIL_BACK_PASS_DEPTH_FAIL,
                                                  GL_STENCIL_BACK_PASS_DEPTH_PASS,
                                                  GL_STENCIL_BACK_WRITEMASK};

constexpr GLenum texture_units = 8;

template <std::size_t size>
void get_all(const std::array<GLenum, size>& names, std::array<int, size>& values) {
  for (std::size_t i = 0; i < size; ++i) glGetIntegerv(names[i], &values[i]);
}

void set_switch(GLenum name, bool on) {
  if (on) {
    glEnable(name);
  } else {
    glDisable(name);
  }
}

void restore_stencil(GLenum face, const int* values) {
  glStencilFuncSeparate(face, static_cast<GLenum>(values[0]), values[1], static_cast<GLuint>(values[2]));
  glStencilOpSeparate(face, static_cast<GLenum>(values[3]), static_cast<GLenum>(values[4]),
                      static_cast<GLenum>(values[5]));
  glStencilMaskSeparate(face, static_cast<GLuint>(values[6]));
}

void unbind_everything() {
  glUseProgram(0);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  for (GLenum unit = 0; unit < texture_units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, 0);
  }
}

}  // namespace

HostState::HostState() {
  static_assert(switches.size() == switch_count);
  for (std::size_t i = 0; i < switch_count; ++i) switches_[i] = glIsEnabled(switches[i]) == GL_TRUE;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_framebuffer_);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_framebuffer_);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active_texture_);
  glGetIntegerv(GL_VIEWPORT, viewport_.data());
  glGetIntegerv(GL_SCISSOR_BOX, scissor_.data());
  get_all(blend_names, blend_);
  get_all(stencil_names, stencil_);
  save_values();
}

void HostState::save_values() {
  glGetBooleanv(GL_COLOR_WRITEMASK, color_mask_.data());
  glGetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask_);
  glGetFloatv(GL_COLOR_CLEAR_VALUE, clear_color_.data());
  glGetFloatv(GL_DEPTH_CLEAR_VALUE, &clear_depth_);
  glGetIntegerv(GL_STENCIL_CLEAR_VALUE, &clear_stencil_);
  glGetIntegerv(GL_DEPTH_FUNC, &depth_function_);
  std::array<int, 2> polygon_modes = {};  // some drivers return front and back even where only one is left
  glGetIntegerv(GL_POLYGON_MODE, polygon_modes.data());
  polygon_mode_ = polygon_modes[0];
  glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &offset_factor_);
  glGetFloatv(GL_POLYGON_OFFSET_UNITS, &offset_units_);
}

HostState::~HostState() {
  bind_framebuffers();
  unbind_everything();
  glActiveTexture(static_cast<GLenum>(active_texture_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  glScissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
  for (std::size_t i = 0; i < switch_count; ++i) set_switch(switches[i], switches_[i]);
  glColorMask(color_mask_[0], color_mask_[1], color_mask_[2], color_mask_[3]);
  glDepthMask(depth_mask_);
  glClearColor(clear_color_[0], clear_color_[1], clear_color_[2], clear_color_[3]);
  glClearDepth(clear_depth_);
  glClearStencil(clear_stencil_);
  glDepthFunc(static_cast<GLenum>(depth_function_));
  glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygon_mode_));
  glPolygonOffset(offset_factor_, offset_units_);
  glBlendFuncSeparate(static_cast<GLenum>(blend_[0]), static_cast<GLenum>(blend_[1]), static_cast<GLenum>(blend_[2]),
                      static_cast<GLenum>(blend_[3]));
  glBlendEquationSeparate(static_cast<GLenum>(blend_[4]), static_cast<GLenum>(blend_[5]));
  restore_stencil(GL_FRONT, stencil_.data());
  restore_stencil(GL_BACK, stencil_.data() + 7);
}

void HostState::bind_framebuffers() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_framebuffer_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_framebuffer_));
}

void set_plain_state() {
  for (const GLenum name : switches) glDisable(name);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glStencilMask(0xFF);
}

}  // namespace croquis::render
