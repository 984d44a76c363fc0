// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis::subdivision {

/// The corners of a mesh by the edges that they start, in either direction.
class EdgePairing {
 public:
  /// Corners of faces in `left_out` (#F flags) start no edge. Linear time for bounded valences.
  /// @param mesh indices in range
  EdgePairing(const PolyMesh& mesh, const std::vector<bool>& left_out);

  /// Every corner that starts the edge between two vertices, ascending; empty where there is no edge.
  std::span<const Index> corners(Index a, Index b) const;

  /// Calls use(corners) for every edge, by ascending lower and then higher vertex.
  template <typename Use>
  void for_each_edge(Use&& use) const {
    for (std::size_t begin = 0; begin < entries_.size();) {
      std::size_t end = begin + 1;
      while (end < entries_.size() && same_edge(begin, end)) ++end;
      use(std::span<const Index>(corners_).subspan(begin, end - begin));
      begin = end;
    }
  }

 private:
  struct Entry {
    Index low, high;
  };
  bool same_edge(std::size_t i, std::size_t j) const {
    return entries_[i].low == entries_[j].low && entries_[i].high == entries_[j].high;
  }

  std::vector<Index> low_offsets_;  ///< #V+1, into the two below
  std::vector<Entry> entries_;      ///< by low, then high
  std::vector<Index> corners_;
};

}  // namespace croquis::subdivision
