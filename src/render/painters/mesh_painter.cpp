// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/mesh_painter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <epoxy/gl.h>

namespace croquis::render {

namespace {

constexpr Color box_color = {120, 124, 132, 255};

bool shows_wire(const MeshStyle& style, const RenderOptions& options) {
  return style.wire.value_or(options.wire || style.surface != SurfaceLook::Filled);
}

/// What is drawn of an item.
const MeshItemPtr& drawn_item(const MeshItemPtr& item, const Drawing& drawing) {
  return drawing.options.reduced && item->reduced ? item->reduced : item;
}

const FaceHighlightPtr& drawn_highlight(const FaceHighlightPtr& highlight, const Drawing& drawing) {
  return drawing.options.reduced && highlight->reduced ? highlight->reduced : highlight;
}

/// In samples.
float wire_width(const MeshStyle& style, const Drawing& drawing) {
  const double width = style.wire_width.value_or(drawing.options.wire_width);
  return static_cast<float>(std::clamp(width, 0.1, 8.0) * drawing.samples_per_pixel());
}

float widest_wire(const Drawing& drawing) {
  float width = wire_width({}, drawing);
  for (const Shown<MeshItem>& shown : drawing.scene.meshes) {
    if (shows_wire(shown.style, drawing.options)) width = std::max(width, wire_width(shown.style, drawing));
  }
  return width;
}

/// Without filled faces it is the wire that shows emphasis.
glm::vec4 wire_color(const Shown<MeshItem>& shown, const RenderOptions& options) {
  glm::vec4 color = to_float(shown.style.wire_color.value_or(options.wire_color));
  if (shown.style.surface == SurfaceLook::Filled) return color;
  const glm::vec4 emphasis = emphasis_color(options.emphasis, shown.emphasis);
  if (emphasis.a > 0) color = glm::vec4(glm::vec3(emphasis), 1);
  if (shown.emphasis.stale) color.a *= static_cast<float>(options.emphasis.faded);
  return color;
}

/// Pixels that an item's mean edge spans where the item is nearest.
double edge_pixels(const Shown<MeshItem>& shown, const ViewFrame& view) {
  const Bounds bounds = bounds_of(shown);
  const double radius = bounds.radius() / view.unit;
  const double middle = -(view.model_to_view * glm::dvec4(bounds.center(), 1)).z;
  const double distance = view.perspective ? std::max(middle - radius, 0.01) : 1;
  const double edge_length =
      shown.item->edge_length * std::cbrt(std::abs(glm::determinant(glm::dmat3(shown.placement))));
  return edge_length / view.unit * view.crop.picture_height / (view.picture_height * distance);
}

/// Wire too dense to show single lines would cover the shape in grey.
double strength_of_dense_wire(const Shown<MeshItem>& shown, const Drawing& drawing) {
  constexpr double gone = 1.5, full = 8;  // pixels between lines
  const double spacing = edge_pixels(shown, drawing.view) / drawing.options.pixel_ratio;
  return std::clamp((spacing - gone) / (full - gone), 0.0, 1.0);
}

void set_emphasis(const ShaderProgram& surface, const RenderOptions& options, const Emphasis& emphasis) {
  glm::vec4 tint = emphasis_color(options.emphasis, emphasis);
  tint.a *= static_cast<float>(options.emphasis.surface_tint);
  const glm::vec4 background = 0.5F * (to_float(options.background_top) + to_float(options.background_bottom));
  const double fade = emphasis.stale ? 1 - options.emphasis.faded : 0;
  surface.set("tint", tint);
  surface.set("fade", glm::vec4(glm::vec3(background), fade));
}

/// Normals go by the inverse transpose, kept near length 1: 0 stands for none.
void set_place(const ShaderProgram& program, const Shown<MeshItem>& shown, const ViewFrame& view) {
  program.set("to_view", glm::mat4(item_to_view(shown, view)));
  const glm::dmat3 linear(shown.placement);
  const double size = std::cbrt(std::abs(glm::determinant(linear)));
  const glm::dmat3 normals = glm::transpose(glm::inverse(linear)) * size;
  program.set("normal_to_view", glm::mat3(glm::dmat3(view.model_to_view * view.unit) * normals));
}

/// Colours are blended over those of the faces, whose shape stays.
void blend_colors_alone(bool on) {
  const auto rest = static_cast<GLboolean>(!on);
  for (const GLuint texture : {1U, 2U}) glColorMaski(texture, rest, rest, rest, rest);
  glDepthMask(rest);
  if (on) {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  } else {
    glDisable(GL_BLEND);
  }
}

const Shown<MeshItem>* find_shown(const Scene& scene, const MeshItemPtr& item) {
  const auto found = std::find_if(scene.meshes.begin(), scene.meshes.end(),
                                  [&](const Shown<MeshItem>& shown) { return shown.item == item; });
  return found != scene.meshes.end() ? &*found : nullptr;
}

float zebra_stripes(const RenderOptions& options) {
  return options.shading == Shading::Zebra ? static_cast<float>(std::clamp(options.zebra_stripes, 2, 200)) : 0.0F;
}

/// Those farthest from the eye first; in the list's order where that is the same.
std::vector<const Shown<MeshItem>*> translucent_from_afar(const Drawing& drawing) {
  std::vector<const Shown<MeshItem>*> found;
  for (const Shown<MeshItem>& shown : drawing.scene.meshes) {
    if (is_translucent(shown)) found.push_back(&shown);
  }
  const auto depth = [&](const Shown<MeshItem>* shown) {
    return (drawing.view.model_to_view * glm::dvec4(bounds_of(*shown).center(), 1)).z;
  };
  std::stable_sort(found.begin(), found.end(), [&](const auto* a, const auto* b) { return depth(a) < depth(b); });
  return found;
}

/// The twelve edges of the cube [-1, 1]^3, end after end.
std::array<LineVertex, 24> box_ends() {
  std::array<LineVertex, 24> ends;
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 4; ++side) {
      glm::vec3 place(0);
      place[(axis + 1) % 3] = (side & 1) == 0 ? -1.0F : 1.0F;
      place[(axis + 2) % 3] = (side & 2) == 0 ? -1.0F : 1.0F;
      for (const float end : {-1.0F, 1.0F}) {
        place[axis] = end;
        ends[count++] = {place, box_color};
      }
    }
  }
  return ends;
}

}  // namespace

GpuMesh& MeshPainter::on_card(const MeshItemPtr& item, const Drawing& drawing) {
  return gpu_meshes_.get(drawn_item(item, drawing), shared_);
}

void MeshPainter::send(const Drawing& drawing) {
  const auto send_those = [&](bool at_once) {
    for (const Shown<MeshItem>& shown : drawing.scene.meshes) {
      if (!shown.item) continue;
      const bool with_wire = shows_wire(shown.style, drawing.options);
      GpuMesh& mesh = on_card(shown.item, drawing);
      if (mesh.goes_at_once(with_wire) == at_once) {
        mesh.send(*drawn_item(shown.item, drawing), with_wire, drawing.uploads);
      }
    }
  };
  send_those(true);
  send_those(false);
  for (const FaceHighlightPtr& highlight : drawing.scene.highlights) {
    if (!highlight || find_shown(drawing.scene, highlight->mesh) == nullptr) continue;
    const GpuMesh& mesh = on_card(highlight->mesh, drawing);
    const FaceHighlightPtr& drawn = drawn_highlight(highlight, drawing);
    gpu_highlights_.get(drawn, mesh, shared_).send(*drawn, drawing.uploads);
  }
  glBindVertexArray(0);
  check_gl("sending meshes to the graphics card");
}

void MeshPainter::drop_expired() {
  gpu_highlights_.drop_expired();
  gpu_meshes_.drop_expired();
  shared_.drop_expired();
}

std::size_t MeshPainter::draw_surfaces(const Drawing& drawing, const FrameBuffers& frame) {
  glBindFramebuffer(GL_FRAMEBUFFER, frame.surface_target.name());
  glViewport(0, 0, frame.size.width(), frame.size.height());
  glClearColor(0, 0, 0, 0);
  glClearDepth(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  // Wire lies in the surface and is some samples wide: surfaces stand back as much as they recede over half of that.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(0.3f + 0.5f * widest_wire(drawing), 4.0f);

  surface_.use();
  surface_.set("to_clip", drawing.view.to_clip);
  surface_.set("perspective", drawing.view.perspective);
  surface_.set("zebra_stripes", zebra_stripes(drawing.options));
  surface_.set("fixed_color", glm::vec4(0));
  std::size_t triangles = 0;
  unsigned first_patch = 0, patch_before = 0;
  for (const Shown<MeshItem>& shown : drawing.scene.meshes) {
    const MeshItemPtr& item = shown.item;
    if (!item || shown.style.surface == SurfaceLook::None || is_translucent(shown)) continue;
    set_emphasis(surface_, drawing.options, shown.emphasis);
    surface_.set("filled", shown.style.surface == SurfaceLook::Filled);
    surface_.set("outlined", shown.emphasis.outlined);
    set_place(surface_, shown, drawing.view);
    if (!shown.style.goes_on) patch_before = first_patch;
    surface_.set("first_patch", patch_before);
    surface_.set("patch_step", shown.style.goes_on ? 0U : 1U);
    on_card(item, drawing).draw_triangles();
    triangles += drawn_item(item, drawing)->triangles.size() / 3;
    first_patch += item->patch_count;
  }
  surface_.set("filled", true);
  surface_.set("outlined", false);
  surface_.set("patch_step", 1U);
  for (const FaceHighlightPtr& highlight : drawing.scene.highlights) draw_highlight(highlight, drawing);
  glDisable(GL_POLYGON_OFFSET_FILL);
  return triangles;
}

void MeshPainter::draw_highlight(const FaceHighlightPtr& highlight, const Drawing& drawing) {
  const Shown<MeshItem>* shown = highlight ? find_shown(drawing.scene, highlight->mesh) : nullptr;
  GpuHighlight* const faces = shown != nullptr ? gpu_highlights_.find(drawn_highlight(highlight, drawing)) : nullptr;
  if (faces == nullptr || is_translucent(*shown) || !on_card(highlight->mesh, drawing).vertices_complete()) return;
  const bool over_faces = shown->style.surface == SurfaceLook::Filled;
  set_emphasis(surface_, drawing.options, {});
  surface_.set("fixed_color", to_float(highlight->color));
  set_place(surface_, *shown, drawing.view);
  surface_.set("first_patch", 0U);
  if (over_faces) blend_colors_alone(true);
  faces->draw();
  if (over_faces) blend_colors_alone(false);
}

void MeshPainter::draw_veil(const Drawing& drawing, const FrameBuffers& frame) {
  glBindFramebuffer(GL_FRAMEBUFFER, frame.veil_target.name());
  glViewport(0, 0, frame.size.width(), frame.size.height());
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(0.3f + 0.5f * widest_wire(drawing), 4.0f);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  veil_.use();
  veil_.set("to_clip", drawing.view.to_clip);
  veil_.set("perspective", drawing.view.perspective);
  veil_.set("first_patch", 0U);
  veil_.set("patch_step", 1U);
  veil_.set("lit", drawing.options.shading == Shading::Clay);
  veil_.set("zebra_stripes", zebra_stripes(drawing.options));
  for (const Shown<MeshItem>* shown : translucent_from_afar(drawing)) {
    set_emphasis(veil_, drawing.options, shown->emphasis);
    veil_.set("opacity", static_cast<float>(std::clamp(shown->style.opacity, 0.0, 1.0)));
    set_place(veil_, *shown, drawing.view);
    // What looks away from the eye is mostly behind what looks to it.
    for (const bool front : {false, true}) {
      veil_.set("front", front);
      on_card(shown->item, drawing).draw_triangles();
    }
  }
  glDisable(GL_BLEND);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthMask(GL_TRUE);
  glDisable(GL_DEPTH_TEST);
}

void MeshPainter::draw_lines(const Drawing& drawing, const FrameBuffers& frame) {
  glBindFramebuffer(GL_FRAMEBUFFER, frame.overlay_target.name());
  glClear(GL_COLOR_BUFFER_BIT);
  for (const ShaderProgram* program : {&thin_wire_, &line_}) {
    program->use();
    program->set("to_clip", drawing.view.to_clip);
    program->set_texture("normals", 0, frame.normals);
    program->set("frame_size", glm::vec2(frame.size.width(), frame.size.height()));
  }
  glDepthMask(GL_FALSE);
  draw_wire(drawing, WireLayer::Covered);  // first, so that what is in front lies over it
  draw_wire(drawing, WireLayer::Seen);
  if (drawing.uploads.pending()) draw_boxes(drawing);
  glDepthMask(GL_TRUE);
  draw_polylines(drawing);
  glDisable(GL_DEPTH_TEST);
}

void MeshPainter::draw_wire(const Drawing& drawing, WireLayer layer) {
  const bool covered = layer == WireLayer::Covered;
  glDepthFunc(covered ? GL_GREATER : GL_LEQUAL);
  for (const Shown<MeshItem>& shown : drawing.scene.meshes) {
    if (!shown.item || !shows_wire(shown.style, drawing.options)) continue;
    const bool alone = shown.style.surface == SurfaceLook::None;
    if (covered && !(alone && shown.style.covered_wire > 0)) continue;
    glm::vec4 color = wire_color(shown, drawing.options);
    if (covered) color.a *= static_cast<float>(std::min(shown.style.covered_wire, 1.0));
    // A dense wire would hide the faces.
    if (shown.style.surface == SurfaceLook::Filled || shown.style.fades_where_dense) {
      color.a *= static_cast<float>(strength_of_dense_wire(shown, drawing));
    }
    if (!(color.a > 0)) continue;
    const float width = wire_width(shown.style, drawing);
    color.a *= std::min(width, 1.0F);
    // Thinner than a sample it would be dotted: it fades instead.
    const ShaderProgram& program = width > 1 ? line_ : thin_wire_;
    program.use();
    program.set("to_view", glm::mat4(item_to_view(shown, drawing.view)));
    program.set("fixed_color", color);
    program.set("width", width);
    program.set("on_surface", !alone);
    // Filled faces end at their contour; where only lines are seen, the outline keeps all of its width.
    program.set("past_outline", shown.style.surface == SurfaceLook::Covers ? 1.0F : 0.0F);
    on_card(shown.item, drawing).draw_edges();
  }
  line_.use();
  glDepthFunc(GL_LEQUAL);
}

void MeshPainter::draw_polylines(const Drawing& drawing) {
  line_.set("on_surface", false);
  line_.set("fixed_color", glm::vec4(0));
  line_.set("width",
            static_cast<float>(std::clamp(drawing.options.line_width, 0.1, 32.0) * drawing.samples_per_pixel()));
  for (const Shown<MeshItem>& shown : drawing.scene.meshes) {
    if (!shown.item || shown.item->segments.empty()) continue;
    line_.set("to_view", glm::mat4(item_to_view(shown, drawing.view)));
    on_card(shown.item, drawing).draw_segments();
  }
}

void MeshPainter::draw_boxes(const Drawing& drawing) {
  if (box_.name() == 0) {
    box_ = make_vertex_array();
    glBindVertexArray(box_.name());
    const std::array<LineVertex, 24> ends = box_ends();
    box_corners_ = upload(GL_ARRAY_BUFFER, std::as_bytes(std::span(ends)));
    bind_line_vertices();
  }
  line_.set("on_surface", false);
  line_.set("fixed_color", to_float(box_color));
  line_.set("width", static_cast<float>(drawing.samples_per_pixel()));
  for (const Shown<MeshItem>& shown : drawing.scene.meshes) {
    if (!shown.item || on_card(shown.item, drawing).shows_something()) continue;
    const Bounds bounds = bounds_of(shown);
    const glm::dvec3 half = 0.5 * bounds.max - 0.5 * bounds.min;
    const glm::dmat4 to_model = glm::scale(glm::translate(glm::dmat4(1), bounds.center()), half);
    line_.set("to_view", glm::mat4(drawing.view.model_to_view * to_model));
    glBindVertexArray(box_.name());
    glDrawArrays(GL_LINES, 0, 24);
  }
}

}  // namespace croquis::render
