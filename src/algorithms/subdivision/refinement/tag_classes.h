// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "croquis/subdivision/half_edges.h"
#include "croquis/subdivision/level.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

/// What the sharp edges that meet at a vertex make of it. Lee, Joo, Hong 2002, section 3.1, knows creases; darts and
/// corners complete it.
enum class VertexClass : std::uint8_t {
  Plain,       ///< no sharp edge, three or more faces: Doo-Sabin's own rules
  ValenceTwo,  ///< no sharp edge, two faces: its face would have two corners
  Dart,        ///< one sharp edge: the end of a chain
  Crease,      ///< two: a chain passes
  Corner       ///< three or more, or pinned, or the only corner of a face on the boundary: stays where it is
};

/// An edge that is sharp in this refinement: tagged with sharpness 1 or more, or on the boundary.
struct SharpLine {
  Index edge = no_index;
  std::array<Index, 2> half_edges = {no_index, no_index};  ///< the second is missing on the boundary
  std::array<Index, 2> vertices = {no_index, no_index};    ///< in the direction of the first half-edge
  double sharpness = 0;                                    ///< infinite on the boundary

  bool on_boundary() const { return half_edges[1] == no_index; }
  std::size_t end_at(Index vertex) const { return vertices[0] == vertex ? 0 : 1; }
};

/// The tagged neighbourhood of a level, as lists.
struct TagClasses {
  std::vector<SharpLine> lines;
  IndexArray line_of_edge;            ///< #E, no_index where the edge isn't sharp
  std::vector<VertexClass> class_of;  ///< #V
  std::vector<std::uint8_t> pinned;   ///< #V
  std::vector<Index> special;         ///< vertices that aren't plain, ascending

  bool sharp(Index edge) const { return line_of_edge[edge] != no_index; }
};

/// Linear in the level, with lists of the tagged neighbourhood's size.
TagClasses classify(const Level& level, const CornerFaces& around, const Rules& rules);

}  // namespace croquis::subdivision
