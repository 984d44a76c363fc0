// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// Triangles whose edges can be split, collapsed and flipped, each in constant time: a table of their sides, three per
/// triangle one behind the other, with the side of the neighbour that runs the other way. Positions of vertices
/// aren't used, and steps aren't checked.
class EditableTriangles {
 public:
  using Side = Index;
  static constexpr Index none = std::numeric_limits<Index>::max();

  EditableTriangles(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count);

  /// Whether no two sides run the same way between the same vertices, and the triangles of every vertex but the first
  /// `open_vertices` are one closed fan.
  bool is_manifold(std::size_t open_vertices) const;

  Index count() const { return static_cast<Index>(from_.size()); }  ///< of sides, those of triangles gone included
  static Side next(Side s) { return s % 3 == 2 ? s - 2 : s + 1; }
  static Side previous(Side s) { return s % 3 == 0 ? s + 2 : s - 1; }
  Index from(Side s) const { return from_[s]; }
  Index to(Side s) const { return from_[next(s)]; }
  Index apex(Side s) const { return from_[previous(s)]; }
  Side out(Index v) const { return out_[v]; }   ///< one that begins at a vertex, which isn't open
  Side twin(Side s) const { return twin_[s]; }  ///< none on a boundary

  /// Of the two sides of an edge inside, the lower one.
  bool is_inner_edge(Side s) const { return from_[s] != none && twin_[s] != none && s < twin_[s]; }

  /// Whether a question is answered by yes for all sides out of a vertex that isn't open.
  template <typename Question>
  bool all_around(Index v, const Question& question) const {
    const Side first = out_[v];
    Side s = first;
    do {
      if (!question(s)) return false;
      s = twin_[previous(s)];
    } while (s != first);
    return true;
  }

  /// Where splits alone have put a side that was there at first.
  Side where_is_now(Side s) const {
    while (moved_to_[s] != none) s = moved_to_[s];
    return s;
  }

  /// Puts a new vertex, the next number, in the middle of an inner edge: two triangles become four.
  void split(Side s);

  /// Moves where an inner edge begins, which isn't an open vertex, to where it ends.
  void collapse(Side s);

  /// The other diagonal of the two triangles at an inner edge; the edge keeps its sides.
  void flip(Side s);

  bool is_gone(Index v) const { return is_gone_[v]; }
  std::vector<std::array<Index, 3>> triangles() const;

 private:
  void find_twins(std::size_t vertex_count);
  bool is_closed_fan(Index v, Index size) const;
  void join(Side a, Side b);
  void set(Side s, Index from);
  Side add_triangle(Index a, Index b, Index c);
  void remember_move(Side from, Side to);

  std::vector<Index> from_;  ///< per side, none where the triangle is gone
  std::vector<Side> twin_;
  std::vector<Side> out_;  ///< per vertex, one of its sides
  std::vector<bool> is_gone_;
  std::vector<Side> moved_to_;      ///< per side, where its first edge has gone
  bool has_doubled_sides_ = false;  ///< two sides run the same way
};

}  // namespace croquis::hole_filling
