// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <list>

#include "render/gl/shader_program.h"
#include "render/painters/drawing.h"
#include "render/painters/mesh_painter.h"

namespace croquis::render {

/// How far hollows look around for what hides their sky.
struct OcclusionReach {
  int pixels = 0;
  double picture_share = 0;  ///< the same relative to the picture's height
};

/// Seven hundredths of the picture's height, but no more pixels than a tile's border may reasonably have.
inline OcclusionReach occlusion_reach(int picture_height) {
  const int pixels = std::clamp(picture_height * 7 / 100, 1, 80);
  return {pixels, static_cast<double>(pixels) / picture_height};
}

/// Draws meshes: first what is seen at every sample into textures, then light and contours from these, only where
/// something may be seen. One sample without hollows is drawn by a quicker method, with plainer contours.
class SurfacePainter {
 public:
  /// Fills the textures; the framebuffer binding and the viewport change. Decides the drawing's samples.
  /// @return how many triangles of opaque surfaces
  std::size_t draw(Drawing& drawing);

  /// Puts surfaces over their backdrop into the framebuffer and viewport that are set, which shows the backdrop.
  /// @param origin the viewport's lower left pixel in that framebuffer
  void compose(const Drawing& drawing, const glm::ivec2& origin);

  const FrameBuffers& buffers() const { return buffers_.front(); }
  std::size_t kept_samples() const;
  void drop_expired() { meshes_.drop_expired(); }

 private:
  void prepare_buffers(Drawing& drawing);
  void find_contours(const Drawing& drawing);
  void find_openness(const Drawing& drawing);
  void set_careful(const Drawing& drawing, const glm::ivec2& origin) const;
  void set_quick(const Drawing& drawing, const glm::ivec2& origin) const;
  void draw_outlines(const Drawing& drawing, const glm::ivec2& origin) const;
  void set_composed(const ShaderProgram& program, const Drawing& drawing, const glm::ivec2& origin) const;
  void fill_screen() const;

  MeshPainter meshes_;
  ShaderProgram contour_detect_ = ShaderProgram({"screen.vert", "contour_detect.frag"});
  ShaderProgram contour_spread_ = ShaderProgram({"screen.vert", "contour_spread.frag"});
  ShaderProgram occlusion_ = ShaderProgram({"screen.vert", "occlusion.frag"});
  ShaderProgram composite_ = ShaderProgram({"screen.vert", "composite.frag", "light.frag"});
  ShaderProgram composite_quick_ = ShaderProgram({"screen.vert", "composite_quick.frag", "light.frag"});
  ShaderProgram outline_ = ShaderProgram({"screen.vert", "outline.frag"});
  GlHandle no_attributes_ = make_vertex_array();  // core profiles draw nothing without a vertex array
  std::list<FrameBuffers> buffers_;               // of views drawn lately, the last one first
};

}  // namespace croquis::render
