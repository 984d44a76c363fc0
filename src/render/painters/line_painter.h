// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/gl/gpu_cache.h"
#include "render/gl/shader_program.h"
#include "render/painters/drawing.h"

namespace croquis::render {

/// Draws lines of constant width on screen into a framebuffer with depth and stencil of its own.
///
/// A run of lines is drawn twice: first the segment that covers each pixel best is found (by depth), then that
/// segment alone colours it; the stencil decides ties. So a line's many overlapping segments look like one shape.
class LinePainter {
 public:
  /// Blending is left on. Depth and stencil of the framebuffer are used up.
  void draw(const std::vector<Shown<LineItem>>& lines, const RenderOptions& options, const OverlayFrame& frame);
  void drop_expired() { gpu_lines_.drop_expired(); }

 private:
  /// The corners on the graphics card.
  struct GpuLines {
    GpuLines(const LineItem& item, Uploads& uploads);
    GlHandle corners;
  };
  /// How one item is drawn this time.
  struct Look {
    glm::vec4 fixed_color = glm::vec4(0);  ///< alpha 0: the corners' own
    float grow = 0;                        ///< pixels on either side
    float strength = 1;
  };

  void draw_item(const Shown<LineItem>& shown, const OverlayFrame& frame, float pixel_ratio, const Look& look);
  void set_lengths(const Shown<LineItem>& shown, const OverlayFrame& frame);
  void bind_run(const LineRun& run, const GpuLines& gpu_lines, bool dashed);
  void draw_run(const LineRun& run);
  void begin_layers();

  ShaderProgram program_ = ShaderProgram({"stroke.vert", "stroke.frag", "visibility.glsl"});
  GlHandle vertex_array_ = make_vertex_array();
  GlHandle lengths_ = make_buffer();
  GpuCache<LineItem, GpuLines> gpu_lines_;
  int layers_used_ = 0;
};

}  // namespace croquis::render
