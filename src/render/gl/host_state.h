// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace croquis::render {

/// OpenGL's state as the host has set it, restored at the end of a drawing, also after an error. Program, vertex array,
/// array buffer and 2D textures are set to none.
class HostState {
 public:
  HostState();
  ~HostState();
  HostState(const HostState&) = delete;
  HostState& operator=(const HostState&) = delete;

  /// Makes the host's framebuffers the ones drawn into and read from.
  void bind_framebuffers() const;

 private:
  static constexpr std::size_t switch_count = 9;

  void save_values();

  int draw_framebuffer_ = 0, read_framebuffer_ = 0, active_texture_ = 0;
  std::array<int, 4> viewport_ = {}, scissor_ = {};
  std::array<bool, switch_count> switches_ = {};
  std::array<unsigned char, 4> color_mask_ = {};
  std::array<float, 4> clear_color_ = {};
  unsigned char depth_mask_ = 0;
  int depth_function_ = 0, polygon_mode_ = 0, clear_stencil_ = 0;
  float clear_depth_ = 1, offset_factor_ = 0, offset_units_ = 0;
  std::array<int, 6> blend_ = {};     ///< source and destination of colour and alpha, equations of colour and alpha
  std::array<int, 14> stencil_ = {};  ///< of front, then back: function, reference, mask, three operations, write mask
};

/// The state that every drawing starts from: nothing is tested, blended or masked.
void set_plain_state();

}  // namespace croquis::render
