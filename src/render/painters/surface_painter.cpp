// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/surface_painter.h"

#include <cmath>

#include <epoxy/gl.h>

namespace croquis::render {
namespace {

/// A sample takes 30 bytes on the graphics card: a view's quick and careful pictures are kept beside each other up to
/// 0.6 GB, and those of other sizes up to 180 MB …
constexpr double most_samples_in_turns = 20e6;
constexpr double most_samples_kept = 6e6;
/// … and a single one gets no more than 1.2 GB.
constexpr double most_samples = 40e6;

double contour_half_width(const Drawing& drawing) {
  return 0.5 * std::clamp(drawing.options.contour_width, 0.5, 8.0) * drawing.samples_per_pixel();
}

int contour_pixels(const Drawing& drawing) {
  return static_cast<int>(std::ceil(contour_half_width(drawing) / drawing.samples));
}

/// Where surfaces, their contours and polylines may be seen.
ScreenRect drawn_part(const Drawing& drawing) {
  const double line_width = std::clamp(drawing.options.line_width, 0.1, 32.0) * drawing.options.pixel_ratio;
  return drawing.seen.grown(2 + contour_pixels(drawing) + static_cast<int>(std::ceil(line_width)));
}

ScreenRect in_viewport(ScreenRect rect, const Drawing& drawing) {
  rect.low = glm::max(rect.low, glm::ivec2(drawing.border));
  rect.high = glm::min(rect.high,
                       glm::ivec2(drawing.border + drawing.viewport.width, drawing.border + drawing.viewport.height));
  return rect;
}

Bounds bounds_of_outlined(const Scene& scene) {
  Bounds bounds;
  for (const Shown<MeshItem>& shown : scene.meshes) {
    if (shown.item && shown.emphasis.outlined && !is_translucent(shown)) bounds.add(bounds_of(shown));
  }
  return bounds;
}

bool is_quick(const Drawing& drawing) { return drawing.samples == 1 && !wants_occlusion(drawing.options); }

/// The driver's limit on textures wins over the samples asked for.
int fitting_samples(int wanted, int pixel_width, int pixel_height) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  const double pixels = static_cast<double>(pixel_width) * pixel_height;
  const int room =
      std::min(largest / std::max(pixel_width, pixel_height), static_cast<int>(std::sqrt(most_samples / pixels)));
  return std::max(1, std::min(std::clamp(wanted, 1, 4), room));
}

double samples_in(const FrameSize& size) { return static_cast<double>(size.width()) * size.height(); }

/// Frees the buffers drawn longest ago until the new ones may stand beside the others.
void drop_oldest(std::list<FrameBuffers>& kept, const FrameSize& wanted) {
  double samples = samples_in(wanted);
  auto last = kept.begin();
  for (; last != kept.end(); ++last) {
    samples += samples_in(last->size);
    if (samples > (last == kept.begin() ? most_samples_in_turns : most_samples_kept)) break;
  }
  kept.erase(last, kept.end());
}

}  // namespace

void SurfacePainter::prepare_buffers(Drawing& drawing) {
  FrameSize size{drawing.viewport.width + 2 * drawing.border, drawing.viewport.height + 2 * drawing.border, 1};
  size.samples = fitting_samples(drawing.options.supersampling, size.pixel_width, size.pixel_height);
  drawing.samples = size.samples;
  const auto found =
      std::find_if(buffers_.begin(), buffers_.end(), [&](const auto& kept) { return kept.size == size; });
  if (found != buffers_.end()) {
    buffers_.splice(buffers_.begin(), buffers_, found);
    return;
  }
  drop_oldest(buffers_, size);  // first free, then allocate as much again
  buffers_.emplace_front(size);
}

std::size_t SurfacePainter::kept_samples() const {
  double samples = 0;
  for (const FrameBuffers& kept : buffers_) samples += samples_in(kept.size);
  return static_cast<std::size_t>(samples);
}

void SurfacePainter::fill_screen() const {
  glBindVertexArray(no_attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void SurfacePainter::find_contours(const Drawing& drawing) {
  glBindFramebuffer(GL_FRAMEBUFFER, buffers_.front().marks_target.name());
  // The spreading reads marks within reach, and composing reads its results within reach.
  set_scissor(drawn_part(drawing).grown(2 * contour_pixels(drawing)), glm::ivec2(0), drawing.samples);
  contour_detect_.use();
  contour_detect_.set_texture("normals", 0, buffers_.front().normals);
  contour_detect_.set_texture("depths", 1, buffers_.front().depths);
  contour_detect_.set("perspective", drawing.view.perspective);
  contour_detect_.set("frame_height", drawing.view.picture_height);
  contour_detect_.set("sample_size", 2 * drawing.view.extent.y / static_cast<float>(buffers_.front().size.height()));
  fill_screen();

  glBindFramebuffer(GL_FRAMEBUFFER, buffers_.front().row_distances_target.name());
  contour_spread_.use();
  contour_spread_.set_texture("marks", 0, buffers_.front().marks);
  contour_spread_.set("reach", static_cast<int>(std::ceil(contour_half_width(drawing))));
  fill_screen();
}

void SurfacePainter::find_openness(const Drawing& drawing) {
  const OcclusionReach reach = occlusion_reach(drawing.view.crop.picture_height);
  glBindFramebuffer(GL_FRAMEBUFFER, buffers_.front().openness_target.name());
  glViewport(0, 0, buffers_.front().size.pixel_width, buffers_.front().size.pixel_height);
  set_scissor(drawn_part(drawing).grown(2), glm::ivec2(0), 1);  // composing smooths over two pixels
  occlusion_.use();
  occlusion_.set_texture("normals", 0, buffers_.front().normals);
  occlusion_.set_texture("depths", 1, buffers_.front().depths);
  occlusion_.set("perspective", drawing.view.perspective);
  occlusion_.set("view_extent", drawing.view.extent);
  occlusion_.set("view_center", drawing.view.center);
  occlusion_.set("samples", drawing.samples);
  occlusion_.set("radius", static_cast<float>(reach.pixels * drawing.samples));
  occlusion_.set("view_radius", static_cast<float>(reach.picture_share) * drawing.view.picture_height);
  occlusion_.set("origin", glm::ivec2(drawing.view.crop.left, drawing.view.crop.bottom) - drawing.border);
  fill_screen();
}

void SurfacePainter::set_composed(const ShaderProgram& program, const Drawing& drawing,
                                  const glm::ivec2& origin) const {
  const FrameBuffers& frame = buffers_.front();
  program.set_texture("colors", 0, frame.colors);
  program.set_texture("normals", 1, frame.normals);
  program.set_texture("depths", 2, frame.depths);
  program.set_texture("overlay", 3, frame.overlay);
  program.set("viewport_origin", origin);
  program.set("border", drawing.border);
  program.set("perspective", drawing.view.perspective);
  program.set("view_extent", drawing.view.extent);
  program.set("view_center", drawing.view.center);
  program.set("lit", drawing.options.shading == Shading::Clay);
  program.set("veiled", has_veil(drawing.scene));
  program.set_texture("veil", 6, has_veil(drawing.scene) ? frame.veil : frame.overlay);
  program.set("contour_color", to_float(drawing.options.contour_color));
}

void SurfacePainter::set_careful(const Drawing& drawing, const glm::ivec2& origin) const {
  composite_.use();
  set_composed(composite_, drawing, origin);
  composite_.set_texture("row_distances", 4, buffers_.front().row_distances);
  composite_.set_texture("openness", 5, buffers_.front().openness);
  composite_.set("samples", drawing.samples);
  composite_.set("occluded", wants_occlusion(drawing.options));
  composite_.set("contours", drawing.options.contours);
  composite_.set("contour_half_width", static_cast<float>(contour_half_width(drawing)));
  composite_.set("contour_reach", static_cast<int>(std::ceil(contour_half_width(drawing))));
}

void SurfacePainter::set_quick(const Drawing& drawing, const glm::ivec2& origin) const {
  composite_quick_.use();
  set_composed(composite_quick_, drawing, origin);
  const int reach = std::max(1, static_cast<int>(std::lround(contour_half_width(drawing))));
  composite_quick_.set("contour_reach", drawing.options.contours ? reach : 0);
  composite_quick_.set("contour_break", 0.02F * drawing.view.picture_height);
}

void SurfacePainter::draw_outlines(const Drawing& drawing, const glm::ivec2& origin) const {
  const Bounds bounds = bounds_of_outlined(drawing.scene);
  if (bounds.empty()) return;
  const EmphasisOptions& options = drawing.options.emphasis;
  const auto pixels = [&](double width) {
    return static_cast<float>(std::clamp(width, 0.0, 16.0) * drawing.options.pixel_ratio);
  };
  const float width = pixels(options.outline_width);
  const float casing = pixels(options.casing_width);
  const glm::ivec2 frame(buffers_.front().size.pixel_width, buffers_.front().size.pixel_height);
  const ScreenRect seen = seen_part(bounds, drawing.view, frame);
  set_scissor(in_viewport(seen.grown(2 + static_cast<int>(std::ceil(width + casing))), drawing),
              origin - drawing.border, 1);
  outline_.use();
  outline_.set_texture("normals", 0, buffers_.front().normals);
  outline_.set("samples", drawing.samples);
  outline_.set("viewport_origin", origin);
  outline_.set("border", drawing.border);
  outline_.set("width", width);
  outline_.set("casing", casing);
  outline_.set("line_color", glm::vec3(to_float(options.outline)));
  outline_.set("casing_color", glm::vec3(to_float(options.outline_casing)));
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  fill_screen();
  glDisable(GL_BLEND);
}

void SurfacePainter::compose(const Drawing& drawing, const glm::ivec2& origin) {
  set_scissor(in_viewport(drawn_part(drawing), drawing), origin - drawing.border, 1);
  if (is_quick(drawing)) {
    set_quick(drawing, origin);
  } else {
    set_careful(drawing, origin);
  }
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  fill_screen();
  glDisable(GL_BLEND);
  draw_outlines(drawing, origin);
  glDisable(GL_SCISSOR_TEST);
}

std::size_t SurfacePainter::draw(Drawing& drawing) {
  meshes_.send(drawing);
  prepare_buffers(drawing);
  const std::size_t triangles = meshes_.draw_surfaces(drawing, buffers_.front());
  meshes_.draw_lines(drawing, buffers_.front());
  if (has_veil(drawing.scene)) {
    buffers_.front().require_veil();
    meshes_.draw_veil(drawing, buffers_.front());
  }
  if (is_quick(drawing)) return triangles;
  if (drawing.options.contours) find_contours(drawing);
  if (wants_occlusion(drawing.options)) find_openness(drawing);
  glDisable(GL_SCISSOR_TEST);
  return triangles;
}

}  // namespace croquis::render
