// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/mark_painter.h"

#include <cstddef>
#include <span>

#include <epoxy/gl.h>

namespace croquis::render {
namespace {

constexpr auto stride = static_cast<GLsizei>(sizeof(MarkVertex));

/// Every place advances once per mark.
void enable_place(GLuint place) {
  glEnableVertexAttribArray(place);
  glVertexAttribDivisor(place, 1);
}

void bind_floats(GLuint place, GLint count, std::size_t offset) {
  enable_place(place);
  glVertexAttribPointer(place, count, GL_FLOAT, GL_FALSE, stride, byte_offset(offset));
}

void bind_color(GLuint place, std::size_t offset) {
  enable_place(place);
  glVertexAttribPointer(place, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, byte_offset(offset));
}

}  // namespace

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
  glVertexAttribIPointer(6, 1, GL_UNSIGNED_INT, stride, byte_offset(offsetof(MarkVertex, shape)));
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

}  // namespace croquis::render
