// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/render/picture_item.h"
#include "render/gl/gpu_cache.h"
#include "render/gl/shader_program.h"
#include "render/painters/drawing.h"

namespace croquis::render {

/// Draws pictures behind everything, one draw call each.
class PicturePainter {
 public:
  /// Blending is left off.
  void draw(const std::vector<ShownPicture>& pictures, const ViewFrame& view, Uploads& uploads);
  void drop_expired() { gpu_pictures_.drop_expired(); }

 private:
  /// The picture on the graphics card: its smallest levels first, so that something of it is seen at once.
  struct GpuPicture {
    explicit GpuPicture(const PictureItem& item);
    void send(const PictureItem& item, Uploads& uploads);

    GlHandle texture;
    std::size_t missing = 0;  ///< levels that aren't complete, the largest ones
    int rows = 0;             ///< of the last one of them that are there
  };

  ShaderProgram program_ = ShaderProgram({"picture.vert", "picture.frag"});
  GlHandle no_attributes_ = make_vertex_array();  // core profiles draw nothing without a vertex array
  GpuCache<PictureItem, GpuPicture> gpu_pictures_;
};

}  // namespace croquis::render
