// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/line_painter.h"

#include <algorithm>
#include <cstddef>
#include <span>

#include <epoxy/gl.h>

#include "render/gl/vertex_places.h"
#include "render/painters/line_lengths.h"

namespace croquis::render {
namespace {

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
