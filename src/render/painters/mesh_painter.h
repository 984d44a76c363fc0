// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/gl/gpu_mesh.h"
#include "render/gl/shader_program.h"
#include "render/gl/uploads.h"
#include "render/painters/drawing.h"

namespace croquis::render {

/// Draws meshes' triangles, highlighted faces, wire and polylines into the textures of one drawing.
class MeshPainter {
 public:
  /// Sends what the drawing needs and its uploads allow, what is small first.
  void send(const Drawing& drawing);

  /// Fills colours, normals and depths. Depth tests are left on.
  /// @return how many triangles
  std::size_t draw_surfaces(const Drawing& drawing, const FrameBuffers& frame);

  /// Fills the overlay with wire and polylines, behind surfaces where these hide them.
  void draw_lines(const Drawing& drawing, const FrameBuffers& frame);

  /// Fills the veil with translucent surfaces, behind others where these hide them; after draw_surfaces.
  void draw_veil(const Drawing& drawing, const FrameBuffers& frame);

  void drop_expired();

 private:
  /// What surfaces hide of wires that have none themselves, and what they leave of all.
  enum class WireLayer { Covered, Seen };

  GpuMesh& on_card(const MeshItemPtr& item, const Drawing& drawing);
  void draw_highlight(const FaceHighlightPtr& highlight, const Drawing& drawing);
  void draw_wire(const Drawing& drawing, WireLayer layer);
  void draw_polylines(const Drawing& drawing);
  void draw_boxes(const Drawing& drawing);

  ShaderProgram surface_ = ShaderProgram({"surface.vert", "surface.frag", "zebra.frag"});
  ShaderProgram veil_ = ShaderProgram({"surface.vert", "veil.frag", "light.frag", "zebra.frag"});
  ShaderProgram line_ = ShaderProgram({"line.vert", "line.geom", "line.frag", "line_fade.glsl"});
  ShaderProgram thin_wire_ = ShaderProgram({"line.vert", "thin_wire.frag", "line_fade.glsl"});
  SharedBuffers shared_;
  GpuCache<MeshItem, GpuMesh> gpu_meshes_;
  GpuCache<FaceHighlight, GpuHighlight> gpu_highlights_;
  GlHandle box_corners_, box_;  // stands for a mesh that isn't there yet
};

}  // namespace croquis::render
