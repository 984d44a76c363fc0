// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/render/mesh_item.h"
#include "render/gl/gl_handle.h"
#include "render/gl/uploads.h"

namespace croquis::render {

/// Arrays that items share, once on the graphics card for all of them.
struct SharedBuffers {
  GpuCache<std::vector<SurfacePaint>, SlicedBuffer> paints;
  GpuCache<std::vector<std::uint32_t>, SlicedBuffer> indices;

  void drop_expired() {
    paints.drop_expired();
    indices.drop_expired();
  }
};

/// Makes the bound vertex array take line vertices from the bound buffer.
void bind_line_vertices();

/// A mesh item's arrays on the graphics card: vertices of its own, the rest shared with its updates.
///
/// It is drawn as far as it is there: nothing before all vertices are, then a growing part of triangles and edges.
class GpuMesh {
 public:
  GpuMesh(const MeshItem& item, SharedBuffers& shared);

  /// Sends what is missing, as far as the uploads allow.
  /// @param with_wire edges are needed
  void send(const MeshItem& item, bool with_wire, Uploads& uploads);

  /// Whether its next upload is small, or an update of a mesh that is there already.
  bool goes_at_once(bool with_wire) const;
  bool vertices_complete() const;
  bool shows_something() const { return vertices_complete() && (triangles_.size() == 0 || triangles_.has_begun()); }

  void draw_triangles() const;
  void draw_edges() const;
  void draw_segments() const;

  /// A vertex array that draws other indices into the same vertices.
  GlHandle index_surface(unsigned index_buffer) const;

 private:
  /// Indices that are drawn with a vertex array of their own; without a buffer there are none.
  struct IndexedArray {
    GlHandle vertex_array;
    SlicedBuffer* indices = nullptr;

    bool complete() const { return indices == nullptr || indices->complete(); }
    bool has_begun() const { return indices != nullptr && indices->sent() > 0; }
    std::size_t size() const { return indices == nullptr ? 0 : indices->size(); }
    void send(const SharedArray<std::uint32_t>& values, bool at_once, Uploads& uploads) const;
    void draw(unsigned mode, int step) const;
  };

  GlHandle index_lines() const;
  void send_vertices(const MeshItem& item, bool at_once, Uploads& uploads);
  void send_shared(const MeshItem& item, bool with_wire, bool at_once, Uploads& uploads);

  SlicedBuffer vertices_, line_vertices_;
  SlicedBuffer* paint_ = nullptr;
  IndexedArray triangles_, edges_, segments_;
  bool is_update_ = false;  ///< another item has begun to send what both share
};

/// A highlight's own indices over its mesh's vertices.
class GpuHighlight {
 public:
  GpuHighlight(const FaceHighlight& highlight, const GpuMesh& mesh, SharedBuffers& shared);

  void send(const FaceHighlight& highlight, Uploads& uploads);
  void draw() const;

 private:
  SlicedBuffer* indices_;
  GlHandle vertex_array_;
};

}  // namespace croquis::render
