// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/gpu_mesh.h"

#include <cstddef>
#include <span>

#include <epoxy/gl.h>

#include "render/gl/uploads.h"

namespace croquis::render {
namespace {

// The places that the shaders give their inputs.
constexpr GLuint normal_place = 1;
constexpr GLuint patch_place = 3;

template <typename Vertex>
void bind_floats(GLuint place, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), byte_offset(offset));
}

template <typename Vertex>
void bind_color(std::size_t offset) {
  glEnableVertexAttribArray(color_place);
  glVertexAttribPointer(color_place, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex), byte_offset(offset));
}

SlicedBuffer* shared_indices(const SharedArray<std::uint32_t>& values, SharedBuffers& shared) {
  return values.empty() ? nullptr : &shared.indices.get(values.shared());
}

template <typename Values>
std::span<const std::byte> bytes_of(const Values& values) {
  return std::as_bytes(std::span(values.data(), values.size()));
}

}  // namespace

void bind_line_vertices() {
  bind_floats<LineVertex>(position_place, offsetof(LineVertex, position));
  bind_color<LineVertex>(offsetof(LineVertex, color));
}

GpuMesh::GpuMesh(const MeshItem& item, SharedBuffers& shared)
    : vertices_(item.vertices), line_vertices_(item.line_vertices) {
  if (!item.paint.empty()) {
    paint_ = &shared.paints.get(item.paint.shared());
    is_update_ = paint_->sent() > 0;
    triangles_.indices = shared_indices(item.triangles, shared);
    edges_.indices = shared_indices(item.edges, shared);
  }
  segments_.indices = shared_indices(item.segments, shared);
  if (triangles_.indices != nullptr) triangles_.vertex_array = index_surface(triangles_.indices->name());
  if (edges_.indices != nullptr) edges_.vertex_array = index_surface(edges_.indices->name());
  if (segments_.indices != nullptr) segments_.vertex_array = index_lines();
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  check_gl("making room for a mesh on the graphics card");
}

GlHandle GpuMesh::index_surface(unsigned index_buffer) const {
  GlHandle array = make_vertex_array();
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  bind_floats<SurfaceVertex>(position_place, offsetof(SurfaceVertex, position));
  bind_floats<SurfaceVertex>(normal_place, offsetof(SurfaceVertex, normal));
  glBindBuffer(GL_ARRAY_BUFFER, paint_->name());
  bind_color<SurfacePaint>(offsetof(SurfacePaint, color));
  glEnableVertexAttribArray(patch_place);
  glVertexAttribIPointer(patch_place, 1, GL_UNSIGNED_INT, sizeof(SurfacePaint),
                         byte_offset(offsetof(SurfacePaint, patch)));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer);
  return array;
}

GlHandle GpuMesh::index_lines() const {
  GlHandle array = make_vertex_array();
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, line_vertices_.name());
  bind_line_vertices();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, segments_.indices->name());
  return array;
}

bool GpuMesh::vertices_complete() const {
  return vertices_.complete() && line_vertices_.complete() && (paint_ == nullptr || paint_->complete());
}

bool GpuMesh::goes_at_once(bool with_wire) const {
  const std::size_t indices = triangles_.size() + segments_.size() + (with_wire ? edges_.size() : 0);
  const std::size_t paint = paint_ == nullptr ? 0 : paint_->size();
  if (vertices_.size() + line_vertices_.size() + paint + indices <= small_item) return true;
  return is_update_ && paint_->complete() && triangles_.complete() && segments_.complete() &&
         (!with_wire || edges_.complete());
}

void GpuMesh::send(const MeshItem& item, bool with_wire, Uploads& uploads) {
  const bool at_once = goes_at_once(with_wire);
  // What an earlier item of this mesh has begun comes first: updates that follow each other would else always
  // begin with their vertices.
  if (is_update_) send_shared(item, with_wire, at_once, uploads);
  if (paint_ != nullptr) paint_->send(bytes_of(item.paint), at_once, uploads);
  send_vertices(item, at_once, uploads);
  send_shared(item, with_wire, at_once, uploads);
}

void GpuMesh::send_vertices(const MeshItem& item, bool at_once, Uploads& uploads) {
  vertices_.send(bytes_of(item.vertices), at_once, uploads);
  line_vertices_.send(bytes_of(item.line_vertices), at_once, uploads);
}

void GpuMesh::send_shared(const MeshItem& item, bool with_wire, bool at_once, Uploads& uploads) {
  if (paint_ != nullptr) paint_->send(bytes_of(item.paint), at_once, uploads);
  triangles_.send(item.triangles, at_once, uploads);
  if (with_wire) edges_.send(item.edges, at_once, uploads);
  segments_.send(item.segments, at_once, uploads);
}

void GpuMesh::IndexedArray::send(const SharedArray<std::uint32_t>& values, bool at_once, Uploads& uploads) const {
  if (indices != nullptr) indices->send(bytes_of(values), at_once, uploads);
}

void GpuMesh::IndexedArray::draw(unsigned mode, int step) const {
  if (indices == nullptr) return;
  const auto count = static_cast<int>(indices->sent() / sizeof(std::uint32_t));
  if (count < step) return;
  glBindVertexArray(vertex_array.name());
  glDrawElements(mode, count - count % step, GL_UNSIGNED_INT, nullptr);
}

void GpuMesh::draw_triangles() const {
  if (vertices_complete()) triangles_.draw(GL_TRIANGLES, 3);
}

void GpuMesh::draw_edges() const {
  if (vertices_complete()) edges_.draw(GL_LINES, 2);
}

void GpuMesh::draw_segments() const {
  if (vertices_complete()) segments_.draw(GL_LINES, 2);
}

GpuHighlight::GpuHighlight(const FaceHighlight& highlight, const GpuMesh& mesh, SharedBuffers& shared)
    : indices_(shared_indices(highlight.triangles, shared)) {
  if (indices_ != nullptr) vertex_array_ = mesh.index_surface(indices_->name());
}

void GpuHighlight::send(const FaceHighlight& highlight, Uploads& uploads) {
  if (indices_ == nullptr) return;
  indices_->send(bytes_of(highlight.triangles), indices_->size() <= small_item, uploads);
}

void GpuHighlight::draw() const {
  if (indices_ == nullptr) return;
  const auto count = static_cast<int>(indices_->sent() / sizeof(std::uint32_t));
  glBindVertexArray(vertex_array_.name());
  glDrawElements(GL_TRIANGLES, count - count % 3, GL_UNSIGNED_INT, nullptr);
}

}  // namespace croquis::render
