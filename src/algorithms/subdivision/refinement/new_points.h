// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "algorithms/subdivision/refinement/compaction.h"
#include "algorithms/subdivision/refinement/sectors.h"
#include "algorithms/subdivision/refinement/tag_classes.h"

namespace croquis::subdivision {

/// The vertices of the next level. First those of face corners, in the order of the corners; then, as a list, those of
/// chains, of kept vertices and of spokes.
///
/// Faces beside an unbanded chain use the chain's points in place of their own.
class NewPoints {
 public:
  NewPoints(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors);

  std::size_t count() const { return own_.kept_count() + listed_.size(); }

  const Compaction& own() const { return own_; }                       ///< corners with a point of their own
  const std::vector<VertexOrigin>& listed() const { return listed_; }  ///< the others

  /// The point that a corner's face uses there; where all corners have their own, their number.
  Index at(Index corner) const { return points_.empty() ? corner : points_[corner]; }

  /// The point of a sharp edge's end (0 or 1 as in SharpLine::vertices). At a corner of the surface without bands it is
  /// the kept point.
  Index chain(Index line, std::size_t end) const { return chain_[line][end]; }
  Index chain_at(const TagClasses& classes, Index line, Index vertex) const {
    return chain(line, classes.lines[line].end_at(vertex));
  }

  Index kept(Index vertex) const { return find(kept_, vertex); }           ///< of a corner of the surface
  Index spoke(Index half_edge) const { return find(spokes_, half_edge); }  ///< no_index where there is none

 private:
  using Table = std::vector<std::pair<Index, Index>>;  ///< (element, point), ascending

  static Index find(const Table& table, Index element);
  Index list_point(const VertexOrigin& origin);
  void list_corner_points(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors);
  void list_kept(const TagClasses& classes);
  void list_chain_ends(const TagClasses& classes, const Sectors& sectors);
  void list_spokes(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors);

  Compaction own_;
  IndexArray points_;  ///< #C, empty where all corners have points of their own
  std::vector<std::array<Index, 2>> chain_;
  Table kept_, spokes_;
  std::vector<VertexOrigin> listed_;
};

}  // namespace croquis::subdivision
