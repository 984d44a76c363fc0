// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "croquis/render/mesh_item.h"
#include "render/gl_handle.h"

namespace croquis::render {

/// An item's arrays on the graphics card.
class GpuItem {
 public:
  explicit GpuItem(const MeshItem& item);

  void draw_triangles() const;
  void draw_edges() const;
  void draw_segments() const;

 private:
  /// Indices that are drawn with a vertex array of their own.
  struct IndexedArray {
    GlHandle vertex_array, indices;
    int count = 0;
  };

  IndexedArray index_surface(const std::vector<std::uint32_t>& indices) const;
  IndexedArray index_lines(const std::vector<std::uint32_t>& indices) const;

  GlHandle surface_vertices_, line_vertices_;
  IndexedArray triangles_, edges_, segments_;
};

/// Every item drawn so far whose owner still holds it.
class GpuItems {
 public:
  /// Uploads the item when it is new.
  const GpuItem& get(const MeshItemPtr& item);

  /// Frees what nobody holds any more.
  void drop_expired();

 private:
  std::map<std::weak_ptr<const MeshItem>, GpuItem, std::owner_less<>> items_;
};

}  // namespace croquis::render
