// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <vector>

#include "croquis/geometry/mesh_tags.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis::subdivision {

/// The edge between two vertices, or no_index. Linear in the valence of `a`.
Index edge_between(const MeshTopology& topology, Index a, Index b);

/// Sharpness of each edge of a mesh, 0 where there is no tag; tags on what is no edge are left out, the last one wins.
std::vector<double> edge_sharpness(const MeshTags& tags, const MeshTopology& topology);

/// Adds to the tags of a mesh without listing anything twice.
class TagChanges {
 public:
  explicit TagChanges(MeshTags& tags);

  /// An infinite crease. A finite one becomes infinite and leaves the named sets, whose members share one sharpness.
  void add_crease(std::array<Index, 2> vertices);
  void add_pin(Index vertex);
  void finish();  ///< sorts the pins

 private:
  MeshTags& tags_;
  std::map<std::array<Index, 2>, std::size_t> crease_of_;
};

}  // namespace croquis::subdivision
