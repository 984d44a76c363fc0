// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include "render/gl/gl_handle.h"

namespace croquis::render {

/// A framebuffer of our own with colour, depth and stencil, as large as the largest viewport so far: the host's may
/// lack what lines need, and its depth is not ours to change.
class Canvas {
 public:
  /// Makes the canvas's lower left part of that size the place to draw into; what it shows is undefined.
  /// @throws Error (E_GL) when the driver can't make one that large
  void begin(const glm::ivec2& size);

  const GlHandle& color() const { return color_; }

 private:
  glm::ivec2 size_ = glm::ivec2(0);
  GlHandle color_, depth_stencil_, framebuffer_;
};

}  // namespace croquis::render
