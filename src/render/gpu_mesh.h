// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "croquis/render/mesh_item.h"
#include "render/gl_handle.h"

namespace croquis::render {

/// A mesh item's arrays on the graphics card.
class GpuMesh {
 public:
  explicit GpuMesh(const MeshItem& item);

  void draw_triangles() const;
  void draw_edges() const;
  void draw_segments() const;

 private:
  /// Indices that are drawn with a vertex array of their own.
  struct IndexedArray {
    GlHandle vertex_array, indices;
    int count = 0;
  };

  IndexedArray index_surface(std::span<const std::uint32_t> indices) const;
  IndexedArray index_lines(std::span<const std::uint32_t> indices) const;

  GlHandle surface_vertices_, paint_, line_vertices_;
  IndexedArray triangles_, edges_, segments_;
};

}  // namespace croquis::render
