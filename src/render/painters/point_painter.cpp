// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/painters/point_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <epoxy/gl.h>

namespace croquis::render {
namespace {

/// Whole pixels, as many as the driver can draw.
float drawn_size(double size, double pixel_ratio) {
  std::array<GLfloat, 2> range = {};
  glGetFloatv(GL_POINT_SIZE_RANGE, range.data());
  const double wanted = std::round(std::clamp(size, 1.0, 32.0) * pixel_ratio);
  return static_cast<float>(std::clamp<double>(wanted, 1, std::floor(range[1])));
}

}  // namespace

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

}  // namespace croquis::render
