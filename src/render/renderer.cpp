// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <epoxy/gl.h>
#include <glm/gtc/matrix_transform.hpp>

#include "render/frame_buffers.h"
#include "render/gpu_item.h"
#include "render/occlusion_reach.h"
#include "render/shader_program.h"
#include "render/view_frame.h"

namespace croquis::render {
namespace {

void require_version() {
  const int version = epoxy_is_desktop_gl() ? epoxy_gl_version() : 0;
  if (version >= 33) return;
  const auto* words = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  throw_gl_error("Pictures need OpenGL 3.3, but the driver offers " +
                 std::string(words != nullptr ? words : "no version at all") + "; install a newer graphics driver.");
}

glm::vec4 to_float(const Color& color) { return glm::vec4(color) / 255.0f; }

/// Puts the host's framebuffer back and leaves nothing bound, however drawing ends.
class HostState {
 public:
  HostState() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
  }
  ~HostState() {
    bind_framebuffers();
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glBindVertexArray(0);
    glUseProgram(0);
    for (GLenum unit = 0; unit < 6; ++unit) {
      glActiveTexture(GL_TEXTURE0 + 5 - unit);
      glBindTexture(GL_TEXTURE_2D, 0);
    }
  }
  HostState(const HostState&) = delete;
  HostState& operator=(const HostState&) = delete;

  void bind_framebuffers() const {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
  }

 private:
  GLint draw_ = 0;
  GLint read_ = 0;
  GLint viewport_[4] = {};
};

void set_plain_state() {
  for (const int capability : {GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DEPTH_TEST}) {
    glDisable(static_cast<GLenum>(capability));
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
}

/// What the passes of one drawing share.
struct Drawing {
  const std::vector<MeshItemPtr>& items;
  const RenderOptions& options;
  const Viewport& viewport;
  ViewFrame view;
  int border = 0;
  int samples = 1;
};

}  // namespace

class Renderer::Implementation {
 public:
  void draw(const std::vector<MeshItemPtr>& items, const Camera& camera, const RenderOptions& options,
            const Viewport& viewport);

 private:
  void prepare_buffers(Drawing& drawing);
  void draw_surfaces(const Drawing& drawing);
  void draw_overlay(const Drawing& drawing);
  void find_contours(const Drawing& drawing);
  void find_openness(const Drawing& drawing);
  void compose(const Drawing& drawing);
  void fill_screen() const;

  ShaderProgram surface_ = ShaderProgram({"surface.vert", "surface.frag"});
  ShaderProgram line_ = ShaderProgram({"line.vert", "line.geom", "line.frag"});
  ShaderProgram contour_detect_ = ShaderProgram({"screen.vert", "contour_detect.frag"});
  ShaderProgram contour_spread_ = ShaderProgram({"screen.vert", "contour_spread.frag"});
  ShaderProgram occlusion_ = ShaderProgram({"screen.vert", "occlusion.frag"});
  ShaderProgram composite_ = ShaderProgram({"screen.vert", "composite.frag"});
  GlHandle no_attributes_ = make_vertex_array();  // core profiles draw nothing without a vertex array
  GpuItems gpu_items_;
  std::optional<FrameBuffers> buffers_;
};

namespace {

glm::dmat4 item_to_view(const MeshItem& item, const ViewFrame& view) {
  return glm::scale(glm::translate(view.model_to_view, item.origin), glm::dvec3(item.scale));
}

double contour_half_width(const Drawing& drawing) {
  return 0.5 * std::clamp(drawing.options.contour_width, 0.5, 8.0) * drawing.samples;
}

float wire_width(const Drawing& drawing) {
  return static_cast<float>(std::clamp(drawing.options.wire_width, 0.1, 8.0) * drawing.samples);
}

/// The driver's limit on textures wins over the samples asked for.
int fitting_samples(int wanted, int pixel_width, int pixel_height) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const int room = largest / std::max(pixel_width, pixel_height);
  return std::max(1, std::min(std::clamp(wanted, 1, 4), room));
}

bool wants_occlusion(const RenderOptions& options) { return options.occlusion && options.shading == Shading::Clay; }

}  // namespace

void Renderer::Implementation::prepare_buffers(Drawing& drawing) {
  FrameSize size{drawing.viewport.width + 2 * drawing.border, drawing.viewport.height + 2 * drawing.border, 1};
  size.samples = fitting_samples(drawing.options.supersampling, size.pixel_width, size.pixel_height);
  drawing.samples = size.samples;
  if (buffers_ && buffers_->size == size) return;
  buffers_.reset();  // first free, then ask for as much again
  buffers_.emplace(size);
}

void Renderer::Implementation::draw_surfaces(const Drawing& drawing) {
  glBindFramebuffer(GL_FRAMEBUFFER, buffers_->surface_target.name());
  glViewport(0, 0, buffers_->size.width(), buffers_->size.height());
  glClearColor(0, 0, 0, 0);
  glClearDepth(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  // Wire lies in the surface and is some samples wide: surfaces stand back as much as they recede over half of that.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(0.3f + 0.5f * wire_width(drawing), 4.0f);

  surface_.use();
  surface_.set("to_clip", drawing.view.to_clip);
  surface_.set("perspective", drawing.view.perspective);
  unsigned first_patch = 0;
  for (const MeshItemPtr& item : drawing.items) {
    surface_.set("to_view", glm::mat4(item_to_view(*item, drawing.view)));
    surface_.set("normal_to_view", glm::mat3(drawing.view.model_to_view * drawing.view.unit));
    surface_.set("first_patch", first_patch);
    gpu_items_.get(item).draw_triangles();
    first_patch += item->patch_count;
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void Renderer::Implementation::draw_overlay(const Drawing& drawing) {
  glBindFramebuffer(GL_FRAMEBUFFER, buffers_->overlay_target.name());
  glClear(GL_COLOR_BUFFER_BIT);
  line_.use();
  line_.set("to_clip", drawing.view.to_clip);
  line_.set_texture("normals", 0, buffers_->normals);
  line_.set("frame_size", glm::vec2(buffers_->size.width(), buffers_->size.height()));
  for (const MeshItemPtr& item : drawing.items) {
    const GpuItem& gpu_item = gpu_items_.get(item);
    line_.set("to_view", glm::mat4(item_to_view(*item, drawing.view)));
    if (drawing.options.wire) {
      line_.set("fixed_color", to_float(drawing.options.wire_color));
      line_.set("width", wire_width(drawing));
      line_.set("on_surface", true);
      glDepthMask(GL_FALSE);
      gpu_item.draw_edges();
      glDepthMask(GL_TRUE);
    }
    line_.set("on_surface", false);
    line_.set("fixed_color", glm::vec4(0));
    line_.set("width", static_cast<float>(std::clamp(drawing.options.line_width, 0.1, 32.0) * drawing.samples));
    gpu_item.draw_segments();
  }
  glDisable(GL_DEPTH_TEST);
}

void Renderer::Implementation::fill_screen() const {
  glBindVertexArray(no_attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::Implementation::find_contours(const Drawing& drawing) {
  glBindFramebuffer(GL_FRAMEBUFFER, buffers_->marks_target.name());
  contour_detect_.use();
  contour_detect_.set_texture("normals", 0, buffers_->normals);
  contour_detect_.set_texture("depths", 1, buffers_->depths);
  contour_detect_.set("perspective", drawing.view.perspective);
  contour_detect_.set("frame_height", drawing.view.picture_height);
  contour_detect_.set("sample_size", 2 * drawing.view.extent.y / static_cast<float>(buffers_->size.height()));
  fill_screen();

  glBindFramebuffer(GL_FRAMEBUFFER, buffers_->row_distances_target.name());
  contour_spread_.use();
  contour_spread_.set_texture("marks", 0, buffers_->marks);
  contour_spread_.set("reach", static_cast<int>(std::ceil(contour_half_width(drawing))));
  fill_screen();
}

void Renderer::Implementation::find_openness(const Drawing& drawing) {
  const OcclusionReach reach = occlusion_reach(drawing.view.crop.picture_height);
  glBindFramebuffer(GL_FRAMEBUFFER, buffers_->openness_target.name());
  glViewport(0, 0, buffers_->size.pixel_width, buffers_->size.pixel_height);
  occlusion_.use();
  occlusion_.set_texture("normals", 0, buffers_->normals);
  occlusion_.set_texture("depths", 1, buffers_->depths);
  occlusion_.set("perspective", drawing.view.perspective);
  occlusion_.set("view_extent", drawing.view.extent);
  occlusion_.set("view_center", drawing.view.center);
  occlusion_.set("samples", drawing.samples);
  occlusion_.set("radius", static_cast<float>(reach.pixels * drawing.samples));
  occlusion_.set("view_radius", static_cast<float>(reach.picture_share) * drawing.view.picture_height);
  occlusion_.set("origin", glm::ivec2(drawing.view.crop.left, drawing.view.crop.bottom) - drawing.border);
  fill_screen();
}

void Renderer::Implementation::compose(const Drawing& drawing) {
  const Viewport& viewport = drawing.viewport;
  const ViewFrame& view = drawing.view;
  const RenderOptions& options = drawing.options;
  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  composite_.use();
  composite_.set_texture("colors", 0, buffers_->colors);
  composite_.set_texture("normals", 1, buffers_->normals);
  composite_.set_texture("depths", 2, buffers_->depths);
  composite_.set_texture("overlay", 3, buffers_->overlay);
  composite_.set_texture("row_distances", 4, buffers_->row_distances);
  composite_.set_texture("openness", 5, buffers_->openness);
  composite_.set("samples", drawing.samples);
  composite_.set("viewport_origin", glm::ivec2(viewport.x, viewport.y));
  composite_.set("border", drawing.border);
  composite_.set("picture_rows", glm::vec2(view.crop.bottom, view.crop.picture_height));
  composite_.set("perspective", view.perspective);
  composite_.set("view_extent", view.extent);
  composite_.set("view_center", view.center);
  composite_.set("background_top", glm::vec3(to_float(options.background_top)));
  composite_.set("background_bottom", glm::vec3(to_float(options.background_bottom)));
  composite_.set("lit", options.shading == Shading::Clay);
  composite_.set("occluded", wants_occlusion(options));
  composite_.set("contours", options.contours);
  composite_.set("contour_half_width", static_cast<float>(contour_half_width(drawing)));
  composite_.set("contour_reach", static_cast<int>(std::ceil(contour_half_width(drawing))));
  composite_.set("contour_color", to_float(options.contour_color));
  fill_screen();
}

void Renderer::Implementation::draw(const std::vector<MeshItemPtr>& items, const Camera& camera,
                                    const RenderOptions& options, const Viewport& viewport) {
  if (viewport.width <= 0 || viewport.height <= 0) return;
  const HostState host;
  set_plain_state();
  gpu_items_.drop_expired();
  Drawing drawing{items, options, viewport, {}};
  // A part of a picture needs what hides its sky from outside, or its rim would show; a whole one can do without.
  drawing.border = 8;
  if (viewport.crop && wants_occlusion(options)) {
    drawing.border += occlusion_reach(viewport.crop->picture_height).pixels;
  }
  drawing.view = make_view_frame(camera, bounds_of(items), viewport, drawing.border);
  prepare_buffers(drawing);
  draw_surfaces(drawing);
  draw_overlay(drawing);
  if (options.contours) find_contours(drawing);
  if (wants_occlusion(options)) find_openness(drawing);
  host.bind_framebuffers();
  check_framebuffer();
  compose(drawing);
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

void Renderer::draw(const std::vector<MeshItemPtr>& items, const Camera& camera, const RenderOptions& options,
                    const Viewport& viewport) {
  implementation_->draw(items, camera, options, viewport);
}

}  // namespace croquis::render
