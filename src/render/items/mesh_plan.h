// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/geometry/surface_normals.h"
#include "croquis/render/mesh_item.h"

namespace croquis::render {

/// Items of more triangles have a reduced surface.
inline constexpr std::size_t most_full_triangles = 45'000;

/// A surface with fewer triangles, for while the camera moves, by clustering of vertices (Rossignac and Borrel,
/// "Multi-resolution 3D approximations for rendering complex scenes", 1993).
///
/// Vertices in one cell of a grid whose normals lie in one octant become one of them: at creases one that lies on the
/// crease, else that nearest to their mean. A place always goes to the same place, so a closed surface stays closed;
/// opposite sides of what is thinner than a cell stay apart. What it is made of is the item's: places, normals, colours
/// and patches.
class ReducedSurface {
 public:
  /// O(n log n)
  /// @param places #V: the vertex, the same for all vertices of the item that are at one place
  ReducedSurface(const MeshItem& item, std::span<const Index> places);

  /// The reduced item of an item with these triangles, as it is now. O(reduced)
  std::shared_ptr<const MeshItem> of(const MeshItem& item) const;

  /// Triangles of the item, three indices each, as those of the reduced item; what they vanish into is left out.
  std::vector<std::uint32_t> reduced(std::span<const std::uint32_t> triangles) const;

  std::size_t triangle_count() const { return triangles_.size() / 3; }

 private:
  struct Source {
    std::uint32_t place;  ///< of the item's vertices: gives the position …
    std::uint32_t look;   ///< … and the normal
  };

  void choose_vertices(const MeshItem& item, std::span<const Index> clusters, std::size_t cluster_count,
                       std::span<const Index> places);

  std::vector<Source> sources_;           // of each reduced vertex
  std::vector<std::uint32_t> vertex_of_;  // #V, of the item's vertices: the reduced one
  std::vector<Index> cluster_of_;         // of each reduced vertex
  SharedArray<SurfacePaint> paint_;
  SharedArray<std::uint32_t> triangles_, edges_;
};

/// What of a mesh item doesn't change while its vertices are moved: which corners share a vertex and a normal,
/// triangles, edges, colours; and what the mesh was, to check whether another one is the same but for its positions.
class MeshPlan {
 public:
  /// @param positions the mesh's vertices in the item's own frame
  MeshPlan(const PolyMesh& mesh, std::span<const Vec3> positions, const MeshItemOptions& options);

  /// Whether only positions and, where normals are read from it, the "normal" channel differ; vertices that were at one
  /// place have to be still.
  bool fits(const PolyMesh& mesh) const;

  /// The box of the vertices in use.
  Bounds bounds_of_drawn(std::span<const Vec3> positions) const;

  /// The channel that normals are read from, by the options and the mesh; or null.
  const AttributeChannel* normals_of(const PolyMesh& mesh) const;

  /// Fills all but frame and bounds of an item.
  /// @param given     positions of a mesh that fits; polygons that they bend may be cut another way
  /// @param positions the same in the item's own frame
  /// @param normals   null: all are computed
  void fill(std::span<const Vec3> given, std::span<const Vec3> positions, const AttributeChannel* normals,
            MeshItem& item) const;

  /// Makes the reduced surface of its items, where they have many triangles. @param item filled
  void reduce(const MeshItem& item);

  const std::optional<ReducedSurface>& reduced() const { return reduced_; }

  const MeshItemOptions& options() const { return options_; }

  /// The triangles of a face: [first, last) in steps of one index.
  std::pair<Index, Index> triangle_indices(Index face) const {
    return {face_triangles_[face], face_triangles_[face + 1]};
  }
  const SharedArray<std::uint32_t>& triangles() const { return triangles_; }  ///< of the mesh as it was at first
  std::size_t vertex_count() const { return vertex_count_; }
  std::size_t face_count() const { return face_offsets_.size() - 1; }

 private:
  void collect_vertices(const PolyMesh& mesh, std::span<const Color> colors, std::span<const Index> patches);
  std::vector<std::uint32_t> cut_triangles(std::span<const Vec3> positions) const;
  void index_lines(const PolyMesh& mesh);
  void take_normals(const AttributeChannel& channel, std::span<SurfaceVertex> vertices) const;
  FaceArrays faces() const { return {face_offsets_, corners_}; }

  MeshItemOptions options_;
  std::size_t vertex_count_ = 0;  // of the mesh
  std::vector<Index> face_offsets_, corners_, line_offsets_, line_vertices_;
  std::vector<Crease> creases_;
  std::vector<AttributeChannel> channels_;        // those that the look depends on
  std::vector<std::array<Index, 2>> coincident_;  // pairs of vertices that count as one
  std::vector<Index> corner_groups_;              // of one normal
  Index group_count_ = 0;
  std::vector<Index> corner_vertices_;  // #C, of the item
  std::vector<Index> vertex_corners_;   // of the item's vertices: the first corner that uses it
  std::vector<Index> face_triangles_;   // #F+1, into the triangles' vertices
  SharedArray<SurfacePaint> paint_;
  SharedArray<std::uint32_t> triangles_, edges_, segments_;
  std::vector<Color> line_colors_;
  Index patch_count_ = 0;
  std::optional<ReducedSurface> reduced_;
};

}  // namespace croquis::render
