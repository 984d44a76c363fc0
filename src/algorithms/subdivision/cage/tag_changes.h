// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <vector>

#include "croquis/geometry/mesh_tags.h"

namespace croquis::subdivision {

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
