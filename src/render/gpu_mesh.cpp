// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu_mesh.h"

#include <cstddef>
#include <span>

#include <epoxy/gl.h>

namespace croquis::render {
namespace {

// The places that the shaders give their inputs.
constexpr GLuint position_place = 0;
constexpr GLuint normal_place = 1;
constexpr GLuint color_place = 2;
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

void draw(const GlHandle& vertex_array, GLenum mode, int count) {
  if (count == 0) return;
  glBindVertexArray(vertex_array.name());
  glDrawElements(mode, count, GL_UNSIGNED_INT, nullptr);
}

}  // namespace

GpuMesh::GpuMesh(const MeshItem& item) {
  surface_vertices_ = upload(GL_ARRAY_BUFFER, std::as_bytes(std::span(item.vertices)));
  paint_ = upload(GL_ARRAY_BUFFER, std::as_bytes(std::span(item.paint)));
  line_vertices_ = upload(GL_ARRAY_BUFFER, std::as_bytes(std::span(item.line_vertices)));
  triangles_ = index_surface(item.triangles);
  edges_ = index_surface(item.edges);
  segments_ = index_lines(item.segments);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  check_gl("sending a mesh to the graphics card");
}

GpuMesh::IndexedArray GpuMesh::index_surface(std::span<const std::uint32_t> indices) const {
  IndexedArray array;
  array.vertex_array = make_vertex_array();
  glBindVertexArray(array.vertex_array.name());
  glBindBuffer(GL_ARRAY_BUFFER, surface_vertices_.name());
  bind_floats<SurfaceVertex>(position_place, offsetof(SurfaceVertex, position));
  bind_floats<SurfaceVertex>(normal_place, offsetof(SurfaceVertex, normal));
  glBindBuffer(GL_ARRAY_BUFFER, paint_.name());
  bind_color<SurfacePaint>(offsetof(SurfacePaint, color));
  glEnableVertexAttribArray(patch_place);
  glVertexAttribIPointer(patch_place, 1, GL_UNSIGNED_INT, sizeof(SurfacePaint),
                         byte_offset(offsetof(SurfacePaint, patch)));
  array.indices = upload(GL_ELEMENT_ARRAY_BUFFER, std::as_bytes(indices));
  array.count = static_cast<int>(indices.size());
  return array;
}

GpuMesh::IndexedArray GpuMesh::index_lines(std::span<const std::uint32_t> indices) const {
  IndexedArray array;
  array.vertex_array = make_vertex_array();
  glBindVertexArray(array.vertex_array.name());
  glBindBuffer(GL_ARRAY_BUFFER, line_vertices_.name());
  bind_floats<LineVertex>(position_place, offsetof(LineVertex, position));
  bind_color<LineVertex>(offsetof(LineVertex, color));
  array.indices = upload(GL_ELEMENT_ARRAY_BUFFER, std::as_bytes(indices));
  array.count = static_cast<int>(indices.size());
  return array;
}

void GpuMesh::draw_triangles() const { draw(triangles_.vertex_array, GL_TRIANGLES, triangles_.count); }
void GpuMesh::draw_edges() const { draw(edges_.vertex_array, GL_LINES, edges_.count); }
void GpuMesh::draw_segments() const { draw(segments_.vertex_array, GL_LINES, segments_.count); }

}  // namespace croquis::render
