// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/renderer.h"

#include <array>
#include <cstddef>
#include <string>

#include <epoxy/gl.h>
#include <glm/glm.hpp>

#include "render/gl/gl_handle.h"
#include "render/painters/backdrop.h"
#include "render/painters/drawing.h"
#include "render/painters/item_painters.h"
#include "render/painters/surface_painter.h"

namespace croquis::render {
namespace {

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

void Canvas::begin(const glm::ivec2& size) {
  if (size.x > size_.x || size.y > size_.y) {
    size_ = glm::max(size_, size);
    color_ = make_texture(GL_RGBA8, size_.x, size_.y);
    depth_stencil_ = make_depth_stencil_buffer(size_.x, size_.y);
    framebuffer_ = make_framebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.name(), 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_stencil_.name());
    check_framebuffer();
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, size.x, size.y);
}

/// OpenGL's state as the host has set it, restored at the end of a drawing, also after an error. Program, vertex array,
/// array buffer and 2D textures are set to none.
class HostState {
 public:
  HostState();
  ~HostState();
  HostState(const HostState&) = delete;
  HostState& operator=(const HostState&) = delete;

  /// Makes the host's framebuffers the ones drawn into and read from.
  void bind_framebuffers() const;

 private:
  static constexpr std::size_t switch_count = 9;

  void save_values();

  int draw_framebuffer_ = 0, read_framebuffer_ = 0, active_texture_ = 0;
  std::array<int, 4> viewport_ = {}, scissor_ = {};
  std::array<bool, switch_count> switches_ = {};
  std::array<unsigned char, 4> color_mask_ = {};
  std::array<float, 4> clear_color_ = {};
  unsigned char depth_mask_ = 0;
  int depth_function_ = 0, polygon_mode_ = 0, clear_stencil_ = 0;
  float clear_depth_ = 1, offset_factor_ = 0, offset_units_ = 0;
  std::array<int, 6> blend_ = {};     ///< source and destination of colour and alpha, equations of colour and alpha
  std::array<int, 14> stencil_ = {};  ///< of front, then back: function, reference, mask, three operations, write mask
};

constexpr std::array<GLenum, 9> switches = {GL_BLEND,
                                            GL_CULL_FACE,
                                            GL_DEPTH_TEST,
                                            GL_SCISSOR_TEST,
                                            GL_STENCIL_TEST,
                                            GL_POLYGON_OFFSET_FILL,
                                            GL_MULTISAMPLE,
                                            GL_SAMPLE_ALPHA_TO_COVERAGE,
                                            GL_PROGRAM_POINT_SIZE};

constexpr std::array<GLenum, 6> blend_names = {GL_BLEND_SRC_RGB,   GL_BLEND_DST_RGB,      GL_BLEND_SRC_ALPHA,
                                               GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};

constexpr std::array<GLenum, 14> stencil_names = {GL_STENCIL_FUNC,
                                                  GL_STENCIL_REF,
                                                  GL_STENCIL_VALUE_MASK,
                                                  GL_STENCIL_FAIL,
                                                  GL_STENCIL_PASS_DEPTH_FAIL,
                                                  GL_STENCIL_PASS_DEPTH_PASS,
                                                  GL_STENCIL_WRITEMASK,
                                                  GL_STENCIL_BACK_FUNC,
                                                  GL_STENCIL_BACK_REF,
                                                  GL_STENCIL_BACK_VALUE_MASK,
                                                  GL_STENCIL_BACK_FAIL,
                                                  GL_STENCIL_BACK_PASS_DEPTH_FAIL,
                                                  GL_STENCIL_BACK_PASS_DEPTH_PASS,
                                                  GL_STENCIL_BACK_WRITEMASK};

constexpr GLenum texture_units = 8;

template <std::size_t size>
void get_all(const std::array<GLenum, size>& names, std::array<int, size>& values) {
  for (std::size_t i = 0; i < size; ++i) glGetIntegerv(names[i], &values[i]);
}

void set_switch(GLenum name, bool on) {
  if (on) {
    glEnable(name);
  } else {
    glDisable(name);
  }
}

void restore_stencil(GLenum face, const int* values) {
  glStencilFuncSeparate(face, static_cast<GLenum>(values[0]), values[1], static_cast<GLuint>(values[2]));
  glStencilOpSeparate(face, static_cast<GLenum>(values[3]), static_cast<GLenum>(values[4]),
                      static_cast<GLenum>(values[5]));
  glStencilMaskSeparate(face, static_cast<GLuint>(values[6]));
}

void unbind_everything() {
  glUseProgram(0);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  for (GLenum unit = 0; unit < texture_units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, 0);
  }
}

HostState::HostState() {
  static_assert(switches.size() == switch_count);
  for (std::size_t i = 0; i < switch_count; ++i) switches_[i] = glIsEnabled(switches[i]) == GL_TRUE;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_framebuffer_);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_framebuffer_);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active_texture_);
  glGetIntegerv(GL_VIEWPORT, viewport_.data());
  glGetIntegerv(GL_SCISSOR_BOX, scissor_.data());
  get_all(blend_names, blend_);
  get_all(stencil_names, stencil_);
  save_values();
}

void HostState::save_values() {
  glGetBooleanv(GL_COLOR_WRITEMASK, color_mask_.data());
  glGetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask_);
  glGetFloatv(GL_COLOR_CLEAR_VALUE, clear_color_.data());
  glGetFloatv(GL_DEPTH_CLEAR_VALUE, &clear_depth_);
  glGetIntegerv(GL_STENCIL_CLEAR_VALUE, &clear_stencil_);
  glGetIntegerv(GL_DEPTH_FUNC, &depth_function_);
  std::array<int, 2> polygon_modes = {};  // some drivers return front and back even where only one is left
  glGetIntegerv(GL_POLYGON_MODE, polygon_modes.data());
  polygon_mode_ = polygon_modes[0];
  glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &offset_factor_);
  glGetFloatv(GL_POLYGON_OFFSET_UNITS, &offset_units_);
}

HostState::~HostState() {
  bind_framebuffers();
  unbind_everything();
  glActiveTexture(static_cast<GLenum>(active_texture_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  glScissor(scissor_[0], scissor_[1], scissor_[2], scissor_[3]);
  for (std::size_t i = 0; i < switch_count; ++i) set_switch(switches[i], switches_[i]);
  glColorMask(color_mask_[0], color_mask_[1], color_mask_[2], color_mask_[3]);
  glDepthMask(depth_mask_);
  glClearColor(clear_color_[0], clear_color_[1], clear_color_[2], clear_color_[3]);
  glClearDepth(clear_depth_);
  glClearStencil(clear_stencil_);
  glDepthFunc(static_cast<GLenum>(depth_function_));
  glPolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygon_mode_));
  glPolygonOffset(offset_factor_, offset_units_);
  glBlendFuncSeparate(static_cast<GLenum>(blend_[0]), static_cast<GLenum>(blend_[1]), static_cast<GLenum>(blend_[2]),
                      static_cast<GLenum>(blend_[3]));
  glBlendEquationSeparate(static_cast<GLenum>(blend_[4]), static_cast<GLenum>(blend_[5]));
  restore_stencil(GL_FRONT, stencil_.data());
  restore_stencil(GL_BACK, stencil_.data() + 7);
}

void HostState::bind_framebuffers() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_framebuffer_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_framebuffer_));
}

/// The state that every drawing starts from: nothing is tested, blended or masked.
void set_plain_state() {
  for (const GLenum name : switches) glDisable(name);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glStencilMask(0xFF);
}

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
int border_of(const RenderOptions& options, const PixelRect& viewport) {
  return 8 + (viewport.crop && wants_occlusion(options) ? occlusion_reach(viewport.crop->picture_height).pixels : 0);
}

bool has_overlay(const Scene& scene, const RenderOptions& options) {
  return !scene.lines.empty() || !scene.points.empty() || !scene.marks.empty() || options.axis_cross.shown;
}

}  // namespace

class Renderer::Implementation {
 public:
  void draw(const Scene& scene, const Camera& camera, const RenderOptions& options, const PixelRect& viewport);
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
                                    const PixelRect& viewport) {
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

void Renderer::draw(const Scene& scene, const Camera& camera, const RenderOptions& options, const PixelRect& viewport) {
  implementation_->draw(scene, camera, options, viewport);
}

void Renderer::draw(const std::vector<MeshItemPtr>& items, const Camera& camera, const RenderOptions& options,
                    const PixelRect& viewport) {
  implementation_->draw(Scene{{items.begin(), items.end()}, {}, {}}, camera, options, viewport);
}

bool Renderer::pending() const { return implementation_->uploads().pending(); }

UploadCount Renderer::uploaded() const { return implementation_->uploads().total(); }

std::size_t Renderer::kept_samples() const { return implementation_->kept_samples(); }

std::size_t Renderer::triangles_drawn() const { return implementation_->triangles_drawn(); }

}  // namespace croquis::render
