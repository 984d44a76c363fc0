// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/gl/gpu_cache.h"
#include "render/gl/shader_program.h"
#include "render/painters/drawing.h"

namespace croquis::render {

/// Draws marks over everything else, a square of fragments each.
class MarkPainter {
 public:
  /// Blending is left on.
  void draw(const std::vector<Shown<MarkItem>>& marks, const RenderOptions& options, const OverlayFrame& frame);
  void drop_expired() { gpu_marks_.drop_expired(); }

 private:
  /// The marks on the graphics card.
  struct GpuMarks {
    GpuMarks(const MarkItem& item, Uploads& uploads);
    GlHandle vertex_array, marks;
  };

  ShaderProgram program_ = ShaderProgram({"mark.vert", "mark.frag", "visibility.glsl"});
  GpuCache<MarkItem, GpuMarks> gpu_marks_;
};

}  // namespace croquis::render
