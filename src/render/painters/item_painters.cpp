// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/item_painters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <epoxy/gl.h>

namespace croquis::render {
namespace {

std::size_t row_bytes(const PictureLevel& level) { return std::size_t{4} * static_cast<std::size_t>(level.width); }

/// All levels, still empty.
GlHandle make_levels(const PictureItem& item) {
  GLuint name = 0;
  glGenTextures(1, &name);
  GlHandle handle(name, [](unsigned texture) { glDeleteTextures(1, &texture); });
  glBindTexture(GL_TEXTURE_2D, name);
  for (std::size_t i = 0; i < item.levels.size(); ++i) {
    const PictureLevel& level = item.levels[i];
    glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(i), GL_RGBA8, level.width, level.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, nullptr);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(item.levels.size()) - 1);
  glBindTexture(GL_TEXTURE_2D, 0);
  return handle;
}

/// Whole pixels, as many as the driver can draw.
float drawn_size(double size, double pixel_ratio) {
  std::array<GLfloat, 2> range = {};
  glGetFloatv(GL_POINT_SIZE_RANGE, range.data());
  const double wanted = std::round(std::clamp(size, 1.0, 32.0) * pixel_ratio);
  return static_cast<float>(std::clamp<double>(wanted, 1, std::floor(range[1])));
}

constexpr auto mark_stride = static_cast<GLsizei>(sizeof(MarkVertex));

/// Every place advances once per mark.
void enable_place(GLuint place) {
  glEnableVertexAttribArray(place);
  glVertexAttribDivisor(place, 1);
}

void bind_floats(GLuint place, GLint count, std::size_t offset) {
  enable_place(place);
  glVertexAttribPointer(place, count, GL_FLOAT, GL_FALSE, mark_stride, byte_offset(offset));
}

void bind_color(GLuint place, std::size_t offset) {
  enable_place(place);
  glVertexAttribPointer(place, 4, GL_UNSIGNED_BYTE, GL_TRUE, mark_stride, byte_offset(offset));
}

/// Takes corners to the screen, and segments as far as they are before the eye.
class Screen {
 public:
  Screen(const Shown<LineItem>& shown, const OverlayFrame& frame)
      : to_view_(item_to_view(shown, frame.view)),
        to_clip_(frame.view.to_clip),
        half_size_(0.5 * glm::dvec2(frame.size)),
        perspective_(frame.view.perspective) {}

  glm::dvec4 in_view(const LineCorner& corner) const { return to_view_ * glm::dvec4(glm::dvec3(corner.position), 1); }

  double length_of(glm::dvec4 a, glm::dvec4 b) const {
    if (perspective_ && !cut(a, b)) return 0;
    return glm::distance(place(a), place(b));
  }

 private:
  static bool cut(glm::dvec4& a, glm::dvec4& b) {
    const double inside_a = -a.z - nearest_overlay;
    const double inside_b = -b.z - nearest_overlay;
    if (std::max(inside_a, inside_b) <= 0) return false;
    if (inside_a < 0) a = glm::mix(a, b, inside_a / (inside_a - inside_b));
    if (inside_b < 0) b = glm::mix(b, a, inside_b / (inside_b - inside_a));
    return true;
  }

  glm::dvec2 place(const glm::dvec4& view) const {
    const glm::dvec4 clip = to_clip_ * view;
    return half_size_ * glm::dvec2(clip) / clip.w;
  }

  glm::dmat4 to_view_, to_clip_;
  glm::dvec2 half_size_;
  bool perspective_;
};

/// The length on screen from each line's start to each of its corners, in pixels, as far as the line lies before the
/// eye: what keeps dashes going around corners. O(corners).
std::vector<float> lengths_on_screen(const Shown<LineItem>& shown, const OverlayFrame& frame) {
  const Screen screen(shown, frame);
  const LineItem& item = *shown.item;
  std::vector<float> lengths(item.corners.size(), 0);
  double length = 0;
  glm::dvec4 previous(0);
  for (std::size_t i = 0; i < item.corners.size(); ++i) {
    const glm::dvec4 here = screen.in_view(item.corners[i]);
    const bool starts_line = i == 0 || item.corners[i - 1].width < 0;
    length = starts_line ? 0 : length + screen.length_of(previous, here);
    lengths[i] = static_cast<float>(length);
    previous = here;
  }
  return lengths;
}

// The places that stroke.vert gives its inputs; those of a segment's second end follow the first one's.
constexpr GLuint width_place = 1;
constexpr GLuint second_end = 3;
constexpr GLuint length_place = 6;

/// Layers between two clearings: as many as the stencil's eight bits can distinguish from each other and from none.
constexpr int layer_count = 255;

/// Corners from one segment to the next.
int step_of(const LineRun& run) { return run.pairs ? 2 : 1; }

void bind_corner(GLuint first_place, std::size_t offset, int step) {
  const GLsizei stride = step * static_cast<GLsizei>(sizeof(LineCorner));
  glVertexAttribPointer(first_place + position_place, 3, GL_FLOAT, GL_FALSE, stride,
                        byte_offset(offset + offsetof(LineCorner, position)));
  glVertexAttribPointer(first_place + width_place, 1, GL_FLOAT, GL_FALSE, stride,
                        byte_offset(offset + offsetof(LineCorner, width)));
  glVertexAttribPointer(first_place + color_place, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                        byte_offset(offset + offsetof(LineCorner, color)));
}

/// Every place advances once per segment.
void enable_places() {
  for (GLuint place = 0; place <= length_place; ++place) {
    glEnableVertexAttribArray(place);
    glVertexAttribDivisor(place, 1);
  }
}

}  // namespace

PicturePainter::GpuPicture::GpuPicture(const PictureItem& item)
    : texture(make_levels(item)), missing(item.levels.size()) {
  check_gl("making room for a picture on the graphics card");
}

void PicturePainter::GpuPicture::send(const PictureItem& item, Uploads& uploads) {
  if (missing == 0) return;
  glBindTexture(GL_TEXTURE_2D, texture.name());
  while (missing > 0) {
    const PictureLevel& level = item.levels[missing - 1];
    const int left = level.height - rows;
    const bool at_once = level.rgba.size() <= small_item;
    const std::size_t granted = uploads.grant(static_cast<std::size_t>(left) * row_bytes(level), at_once);
    const int now = std::min(left, static_cast<int>(granted / row_bytes(level)));
    if (now == 0) break;
    glTexSubImage2D(GL_TEXTURE_2D, static_cast<GLint>(missing) - 1, 0, rows, level.width, now, GL_RGBA,
                    GL_UNSIGNED_BYTE, level.rgba.data() + static_cast<std::size_t>(rows) * row_bytes(level));
    uploads.count(static_cast<std::size_t>(now) * row_bytes(level));
    rows += now;
    if (rows < level.height) break;
    rows = 0;
    --missing;
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, static_cast<GLint>(std::min(missing, item.levels.size() - 1)));
  glBindTexture(GL_TEXTURE_2D, 0);
}

void PicturePainter::draw(const std::vector<ShownPicture>& pictures, const ViewFrame& view, Uploads& uploads) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(no_attributes_.name());
  program_.use();
  program_.set("to_clip", view.to_clip);
  for (const ShownPicture& shown : pictures) {
    if (!shown.item || shown.opacity <= 0) continue;
    GpuPicture& picture = gpu_pictures_.get(shown.item);
    picture.send(*shown.item, uploads);
    // In double precision: pictures may lie far from the origin.
    const auto direction = [&](const glm::dvec3& way) { return glm::vec3(view.model_to_view * glm::dvec4(way, 0)); };
    program_.set("corner", glm::vec3(view.model_to_view * glm::dvec4(shown.corner, 1)));
    program_.set("right", direction(shown.right));
    program_.set("upwards", direction(shown.upwards));
    program_.set("opacity", static_cast<float>(std::min(shown.opacity, 1.0)));
    program_.set_texture("picture", 0, picture.texture);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glDisable(GL_BLEND);
}

PointPainter::GpuPoints::GpuPoints(const PointItem& item)
    : places(item.places), colors(item.colors), vertex_array(make_vertex_array()) {
  glBindVertexArray(vertex_array.name());
  glBindBuffer(GL_ARRAY_BUFFER, places.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  if (!item.colors.empty()) {
    glBindBuffer(GL_ARRAY_BUFFER, colors.name());
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Color), nullptr);
  }
  check_gl("making room for points on the graphics card");
}

void PointPainter::GpuPoints::send(const PointItem& item, Uploads& uploads) {
  const bool at_once = places.size() + colors.size() <= small_item;
  colors.send(std::as_bytes(std::span(item.colors)), at_once, uploads);
  places.send(std::as_bytes(std::span(item.places)), at_once, uploads);
}

int PointPainter::GpuPoints::count() const {
  return colors.complete() ? static_cast<int>(places.sent() / sizeof(glm::vec3)) : 0;
}

void PointPainter::draw(const std::vector<Shown<PointItem>>& points, const RenderOptions& options,
                        const OverlayFrame& frame) {
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_PROGRAM_POINT_SIZE);
  program_.use();
  program_.set("to_clip", frame.view.to_clip);
  program_.set("perspective", frame.view.perspective);
  program_.set("frame_size", frame.size);
  program_.set("nearest", nearest_overlay);
  for (const Shown<PointItem>& shown : points) {
    const PointItemPtr& item = shown.item;
    if (!item || item->places.empty() || (item->colors.empty() && item->style.color.a == 0)) continue;
    draw_item(shown, options, frame);
  }
  glDisable(GL_PROGRAM_POINT_SIZE);
}

void PointPainter::draw_item(const Shown<PointItem>& shown, const RenderOptions& options, const OverlayFrame& frame) {
  const PointItemPtr& item = shown.item;
  GpuPoints& gpu_points = gpu_points_.get(item);
  gpu_points.send(*item, frame.uploads);
  const PointStyle& style = item->style;
  program_.set("to_view", glm::mat4(item_to_view(shown, frame.view)));
  program_.set("size", drawn_size(style.size, options.pixel_ratio));
  program_.set("fixed_color", item->colors.empty() ? to_float(style.color) : glm::vec4(0));
  program_.set("outline", to_float(style.outline));
  program_.set("outline_width", static_cast<float>(std::max(1.0, std::round(options.pixel_ratio))));
  program_.set("disc", style.shape == PointShape::Disc);
  set_visibility(program_, frame, style.depth == PointDepth::Surfaces);
  glBindVertexArray(gpu_points.vertex_array.name());
  glDrawArrays(GL_POINTS, 0, gpu_points.count());
}

MarkPainter::GpuMarks::GpuMarks(const MarkItem& item, Uploads& uploads) : vertex_array(make_vertex_array()) {
  glBindVertexArray(vertex_array.name());
  marks = upload(GL_ARRAY_BUFFER, std::as_bytes(std::span(item.marks)));
  uploads.count(item.marks.size() * sizeof(MarkVertex));
  // In the order of mark.vert's inputs; lengths and angles follow each other in memory.
  bind_floats(0, 3, offsetof(MarkVertex, position));
  bind_floats(1, 3, offsetof(MarkVertex, size));
  bind_floats(2, 2, offsetof(MarkVertex, angle));
  bind_color(3, offsetof(MarkVertex, color));
  bind_color(4, offsetof(MarkVertex, outline));
  bind_color(5, offsetof(MarkVertex, halo));
  enable_place(6);
  glVertexAttribIPointer(6, 1, GL_UNSIGNED_INT, mark_stride, byte_offset(offsetof(MarkVertex, shape)));
  check_gl("sending marks to the graphics card");
}

void MarkPainter::draw(const std::vector<Shown<MarkItem>>& marks, const RenderOptions& options,
                       const OverlayFrame& frame) {
  const auto ratio = static_cast<float>(options.pixel_ratio);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  program_.use();
  program_.set("to_clip", frame.view.to_clip);
  program_.set("perspective", frame.view.perspective);
  program_.set("frame_size", frame.size);
  program_.set("pixel_ratio", ratio);
  program_.set("nearest", nearest_overlay);
  program_.set("glow_width", ratio * static_cast<float>(options.emphasis.glow));
  for (const Shown<MarkItem>& shown : marks) {
    if (!shown.item || shown.item->marks.empty()) continue;
    const GpuMarks& gpu_marks = gpu_marks_.get(shown.item, frame.uploads);
    program_.set("to_view", glm::mat4(item_to_view(shown, frame.view)));
    program_.set("glow_color", emphasis_color(options.emphasis, shown.emphasis));
    program_.set("strength", shown.emphasis.stale ? static_cast<float>(options.emphasis.faded) : 1.0F);
    set_visibility(program_, frame, shown.item->depth == MarkDepth::Tested);
    glBindVertexArray(gpu_marks.vertex_array.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(shown.item->marks.size()));
  }
}

LinePainter::GpuLines::GpuLines(const LineItem& item, Uploads& uploads)
    : corners(upload(GL_ARRAY_BUFFER, std::as_bytes(std::span(item.corners)))) {
  uploads.count(item.corners.size() * sizeof(LineCorner));
  check_gl("sending lines to the graphics card");
}

void LinePainter::begin_layers() {
  glDepthMask(GL_TRUE);
  glClearDepth(1);
  glClearStencil(0);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  layers_used_ = 0;
}

void LinePainter::draw(const std::vector<Shown<LineItem>>& lines, const RenderOptions& options,
                       const OverlayFrame& frame) {
  const auto ratio = static_cast<float>(options.pixel_ratio);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_STENCIL_TEST);
  glBindVertexArray(vertex_array_.name());
  enable_places();
  begin_layers();
  for (const Shown<LineItem>& shown : lines) {
    if (!shown.item || shown.item->corners.empty()) continue;
    const float strength = shown.emphasis.stale ? static_cast<float>(options.emphasis.faded) : 1;
    const glm::vec4 glow = emphasis_color(options.emphasis, shown.emphasis);
    const float grow = static_cast<float>(options.emphasis.glow) * ratio;
    if (glow.a > 0) draw_item(shown, frame, ratio, {glow, grow, strength});
    draw_item(shown, frame, ratio, {glm::vec4(0), 0, strength});
  }
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_DEPTH_TEST);
}

void LinePainter::draw_item(const Shown<LineItem>& shown, const OverlayFrame& frame, float pixel_ratio,
                            const Look& look) {
  const LineItemPtr& item = shown.item;
  const GpuLines& gpu_lines = gpu_lines_.get(item, frame.uploads);
  const DashPattern& dash = item->style.dash;
  const bool dashed = !dash.solid() && look.grow == 0;  // a glow runs through
  program_.use();
  program_.set("to_view", glm::mat4(item_to_view(shown, frame.view)));
  program_.set("to_clip", frame.view.to_clip);
  program_.set("perspective", frame.view.perspective);
  program_.set("frame_size", frame.size);
  program_.set("pixel_ratio", pixel_ratio);
  program_.set("grow", look.grow);
  program_.set("fixed_color", look.fixed_color);
  program_.set("strength", look.strength);
  program_.set("nearest", nearest_overlay);
  program_.set("dashed", dashed);
  program_.set("dashes", pixel_ratio * glm::vec4(dash.on, dash.off, dash.second_on, dash.second_off));
  set_visibility(program_, frame, item->style.depth != LineDepth::OnTop);
  program_.set("seen_at_middle", item->style.depth == LineDepth::OnSurface);
  if (dashed) set_lengths(shown, frame);
  for (const LineRun& run : item->runs) {
    bind_run(run, gpu_lines, dashed);
    draw_run(run);
  }
}

void LinePainter::set_lengths(const Shown<LineItem>& shown, const OverlayFrame& frame) {
  const std::vector<float> lengths = lengths_on_screen(shown, frame);
  glBindBuffer(GL_ARRAY_BUFFER, lengths_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(lengths.size() * sizeof(float)), lengths.data(),
               GL_STREAM_DRAW);
}

void LinePainter::bind_run(const LineRun& run, const GpuLines& gpu_lines, bool dashed) {
  const std::size_t first = run.first * sizeof(LineCorner);
  glBindBuffer(GL_ARRAY_BUFFER, gpu_lines.corners.name());
  bind_corner(0, first, step_of(run));
  bind_corner(second_end, first + sizeof(LineCorner), step_of(run));
  if (!dashed) {
    glDisableVertexAttribArray(length_place);
    return;
  }
  glEnableVertexAttribArray(length_place);
  glBindBuffer(GL_ARRAY_BUFFER, lengths_.name());
  glVertexAttribPointer(length_place, 1, GL_FLOAT, GL_FALSE, step_of(run) * static_cast<GLsizei>(sizeof(float)),
                        byte_offset(run.first * sizeof(float)));
}

void LinePainter::draw_run(const LineRun& run) {
  if (run.count < 2) return;
  if (layers_used_ == layer_count) begin_layers();
  ++layers_used_;
  const auto segments = static_cast<GLsizei>(run.pairs ? run.count / 2 : run.count - 1);
  program_.set("layer", 1 - static_cast<float>(layers_used_) / (layer_count + 1));
  program_.set("layer_depth", 1.0F / (layer_count + 1));

  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glStencilFunc(GL_ALWAYS, 0, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, segments);

  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_EQUAL);
  glStencilFunc(GL_NOTEQUAL, layers_used_, 0xFF);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, segments);
}

}  // namespace croquis::render
