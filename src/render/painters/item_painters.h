// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/render/picture_item.h"
#include "croquis/render/point_item.h"
#include "render/gl/shader_program.h"
#include "render/gl/uploads.h"
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
