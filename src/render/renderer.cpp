// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/renderer.h"

#include <algorithm>
#include <string>

#include <epoxy/gl.h>

#include "render/gl/canvas.h"
#include "render/gl/host_state.h"
#include "render/painters/axis_cross.h"
#include "render/painters/backdrop.h"
#include "render/painters/drawing.h"
#include "render/painters/line_painter.h"
#include "render/painters/mark_painter.h"
#include "render/painters/occlusion_reach.h"
#include "render/painters/picture_painter.h"
#include "render/painters/point_painter.h"
#include "render/painters/surface_painter.h"

namespace croquis::render {
namespace {

void require_version() {
  const int version = epoxy_is_desktop_gl() ? epoxy_gl_version() : 0;
  if (version >= 33) return;
  const auto* words = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  throw_gl_error("Pictures need OpenGL 3.3, but the driver offers " +
                 std::string(words != nullptr ? words : "no version at all") + "; install a newer graphics driver.");
}

Bounds bounds_of_surfaces(const Scene& scene) {
  Bounds bounds;
  for (const Shown<MeshItem>& shown : scene.meshes) {
    if (const Bounds box = bounds_of(shown); !box.empty()) bounds.add(box);
  }
  return bounds;
}

/// A part of a picture needs what hides its sky from outside, or its sides would be seen; a whole one doesn't.
int border_of(const RenderOptions& options, const Viewport& viewport) {
  return 8 + (viewport.crop && wants_occlusion(options) ? occlusion_reach(viewport.crop->picture_height).pixels : 0);
}

bool has_overlay(const Scene& scene, const RenderOptions& options) {
  return !scene.lines.empty() || !scene.points.empty() || !scene.marks.empty() || options.axis_cross.shown;
}

}  // namespace

class Renderer::Implementation {
 public:
  void draw(const Scene& scene, const Camera& camera, const RenderOptions& options, const Viewport& viewport);
  const Uploads& uploads() const { return uploads_; }
  std::size_t triangles_drawn() const { return triangles_drawn_; }
  std::size_t kept_samples() const { return surfaces_.kept_samples(); }

 private:
  void drop_expired();
  void draw_picture(const Drawing& drawing, const glm::ivec2& origin, const ViewFrame& view);
  void draw_overlay(const Drawing& drawing, const OverlayFrame& frame);
  void copy_canvas(const glm::ivec2& origin);
  void fill_screen() const;

  PicturePainter pictures_;
  SurfacePainter surfaces_;
  LinePainter lines_;
  PointPainter points_;
  MarkPainter marks_;
  Canvas canvas_;
  Uploads uploads_;
  std::size_t triangles_drawn_ = 0;
  ShaderProgram paper_ = ShaderProgram({"screen.vert", "paper.frag", "backdrop.frag"});
  ShaderProgram copy_ = ShaderProgram({"screen.vert", "copy.frag"});
  GlHandle no_attributes_ = make_vertex_array();  // core profiles draw nothing without a vertex array
};

void Renderer::Implementation::drop_expired() {
  pictures_.drop_expired();
  surfaces_.drop_expired();
  lines_.drop_expired();
  points_.drop_expired();
  marks_.drop_expired();
}

void Renderer::Implementation::fill_screen() const {
  glBindVertexArray(no_attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// @param view exactly the viewport, without the border
void Renderer::Implementation::draw_picture(const Drawing& drawing, const glm::ivec2& origin, const ViewFrame& view) {
  paper_.use();
  paper_.set("viewport_origin", origin);
  set_backdrop(paper_, drawing.options, drawing.view);
  fill_screen();
  if (!drawing.scene.pictures.empty()) pictures_.draw(drawing.scene.pictures, view, drawing.uploads);
  if (!drawing.scene.meshes.empty()) surfaces_.compose(drawing, origin);
}

void Renderer::Implementation::draw_overlay(const Drawing& drawing, const OverlayFrame& frame) {
  const RenderOptions& options = drawing.options;
  if (!drawing.scene.lines.empty()) lines_.draw(drawing.scene.lines, options, frame);
  if (!drawing.scene.points.empty()) points_.draw(drawing.scene.points, options, frame);
  if (!drawing.scene.marks.empty()) marks_.draw(drawing.scene.marks, options, frame);
  if (options.axis_cross.shown) lines_.draw(axis_cross(options, frame.view), options, pixel_frame(frame));
  glDisable(GL_BLEND);
}

void Renderer::Implementation::copy_canvas(const glm::ivec2& origin) {
  copy_.use();
  copy_.set_texture("canvas", 0, canvas_.color());
  copy_.set("viewport_origin", origin);
  fill_screen();
}

void Renderer::Implementation::draw(const Scene& scene, const Camera& camera, const RenderOptions& options,
                                    const Viewport& viewport) {
  if (viewport.width <= 0 || viewport.height <= 0) return;
  const HostState host;
  set_plain_state();
  drop_expired();
  uploads_.begin_drawing(options.upload_budget);
  const Bounds bounds = bounds_of_surfaces(scene);
  const glm::ivec2 size(viewport.width, viewport.height);
  Drawing drawing{scene, options, viewport, {}, border_of(options, viewport), 1, {}, uploads_};
  drawing.view = make_view_frame(camera, bounds, viewport, drawing.border);
  drawing.seen = seen_part(bounds, drawing.view, size + 2 * drawing.border);
  triangles_drawn_ = scene.meshes.empty() ? 0 : surfaces_.draw(drawing);

  const glm::ivec2 origin(viewport.x, viewport.y);
  const ViewFrame view = make_view_frame(camera, bounds, viewport, 0);
  if (has_overlay(scene, options)) {
    const OverlayFrame frame{view, glm::vec2(size), scene.meshes.empty() ? nullptr : &surfaces_.buffers(),
                             drawing.border, uploads_};
    canvas_.begin(size);
    draw_picture(drawing, glm::ivec2(0), view);
    draw_overlay(drawing, frame);
  }
  host.bind_framebuffers();
  check_framebuffer();
  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  if (has_overlay(scene, options)) {
    copy_canvas(origin);
  } else {
    draw_picture(drawing, origin, view);
  }
  check_gl("drawing a picture");
}

Renderer::Renderer() {
  require_version();
  implementation_ = std::make_unique<Implementation>();
  check_gl("making the renderer");
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::draw(const Scene& scene, const Camera& camera, const RenderOptions& options, const Viewport& viewport) {
  implementation_->draw(scene, camera, options, viewport);
}

void Renderer::draw(const std::vector<MeshItemPtr>& items, const Camera& camera, const RenderOptions& options,
                    const Viewport& viewport) {
  implementation_->draw(Scene{{items.begin(), items.end()}, {}, {}}, camera, options, viewport);
}

bool Renderer::pending() const { return implementation_->uploads().pending(); }

UploadCount Renderer::uploaded() const { return implementation_->uploads().total(); }

std::size_t Renderer::kept_samples() const { return implementation_->kept_samples(); }

std::size_t Renderer::triangles_drawn() const { return implementation_->triangles_drawn(); }

}  // namespace croquis::render
