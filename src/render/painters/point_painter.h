// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/render/point_item.h"
#include "render/gl/gpu_cache.h"
#include "render/gl/shader_program.h"
#include "render/painters/drawing.h"

namespace croquis::render {

/// Draws points, one draw call per item.
class PointPainter {
 public:
  /// Blending is left on.
  void draw(const std::vector<Shown<PointItem>>& points, const RenderOptions& options, const OverlayFrame& frame);
  void drop_expired() { gpu_points_.drop_expired(); }

 private:
  /// The points on the graphics card, as far as they are there.
  struct GpuPoints {
    explicit GpuPoints(const PointItem& item);
    void send(const PointItem& item, Uploads& uploads);
    int count() const;

    SlicedBuffer places, colors;
    GlHandle vertex_array;
  };

  void draw_item(const Shown<PointItem>& shown, const RenderOptions& options, const OverlayFrame& frame);

  ShaderProgram program_ = ShaderProgram({"point.vert", "visibility.glsl", "point.frag"});
  GpuCache<PointItem, GpuPoints> gpu_points_;
};

}  // namespace croquis::render
