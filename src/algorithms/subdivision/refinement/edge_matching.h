// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::subdivision {

/// Half-edges of the next level whose twin doesn't follow from numbers: paired by their vertices.
///
/// Only the tagged neighbourhood comes here, with n log n.
class EdgeMatching {
 public:
  struct Edge {
    Index low = no_index, high = no_index;     ///< vertices
    Index lower = no_index, upper = no_index;  ///< half-edges; the upper one is missing on the boundary
    Index number = no_index;
  };

  void reserve(std::size_t count) { open_.reserve(count); }

  /// @param from, to its vertices
  void add(Index half_edge, Index from, Index to);

  /// Pairs what was added and numbers the edges. The quads of plain edges have numbers for theirs already: of half-edge
  /// h, h - quads_begin.
  /// @throws Error (E_INTERNAL) when that is no manifold
  void match(Index quads_begin, Index quads_end);

  const std::vector<Edge>& edges() const { return edges_; }  ///< ascending by (low, high)
  std::size_t new_edge_count() const { return new_edges_; }  ///< those not numbered before

  /// The number of the edge between two vertices.
  /// @throws Error (E_INTERNAL) where there is none
  Index edge_between(Index a, Index b) const;

 private:
  struct Open {
    std::uint64_t ends;  ///< the lower vertex above the higher one: sorts by both
    Index half_edge;
    bool ascending;  ///< runs from the lower to the higher
  };

  std::vector<Open> open_;
  std::vector<Edge> edges_;
  std::size_t new_edges_ = 0;
};

}  // namespace croquis::subdivision
