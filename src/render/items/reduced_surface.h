// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

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

}  // namespace croquis::render
