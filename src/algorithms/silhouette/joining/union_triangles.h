// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/silhouette/surface/shell.h"

namespace croquis::silhouette {

/// A triangle, and which piece of a joined surface it belongs to: the front or the back of an object.
struct SidedTriangle {
  std::array<Index, 3> corners{no_index, no_index, no_index};
  Index side = 0;  ///< twice the object, and one more for its front
  double off = 0;  ///< how far it lies from the surface given, at most
};

/// An edge that leaves a vertex, with the triangles on both sides of it.
struct Spoke {
  Index to = no_index;
  Index left = no_index;
  Index right = no_index;
};

/// Some triangles of a closed surface, and those that they would be replaced by; one vertex may move.
struct Exchange {
  std::vector<Index> removed;
  std::vector<SidedTriangle> added;
  Index moved = no_index;
  Vec3 place = Vec3::Zero();  ///< of the vertex that moves
};

/// A closed surface whose triangles can be replaced, a few at a time.
class UnionTriangles {
 public:
  explicit UnionTriangles(const Shell& joined);

  std::size_t size() const { return triangles_.size(); }
  bool is_dead(Index t) const { return triangles_[t].corners[0] == no_index; }
  const std::array<Index, 3>& corners(Index t) const { return triangles_[t].corners; }
  Index side(Index t) const { return triangles_[t].side; }
  double off(Index t) const { return triangles_[t].off; }
  const Vec3& position(Index v) const { return positions_[v]; }

  /// Triangles around a vertex, in no order.
  const std::vector<Index>& star(Index v) const { return stars_[v]; }

  /// Edges that leave a vertex, in no order.
  std::vector<Spoke> spokes(Index v) const;

  bool joins(Index a, Index b) const;

  /// The triangle beyond the edge that is opposite to a corner.
  Index beyond(Index t, std::size_t corner) const;

  /// Whether triangles of two pieces meet there: the outline of an object, or a seam.
  bool is_feature(const Spoke& spoke) const { return side(spoke.left) != side(spoke.right); }

  /// @return the new triangles
  std::vector<Index> apply(const Exchange& exchange);

  /// Writes the surface back. @return ascending, the faces that are new or have a vertex that moved
  std::vector<Index> write(Shell& joined) const;

  /// Of the surface that was written, per vertex the one of the surface given.
  std::vector<Index> written_vertices() const;

 private:
  std::vector<Vec3> positions_;
  std::vector<SidedTriangle> triangles_;
  std::vector<std::uint8_t> changed_;  ///< per triangle
  std::vector<std::vector<Index>> stars_;
};

}  // namespace croquis::silhouette
