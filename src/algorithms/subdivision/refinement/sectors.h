// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
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

/// The faces of a vertex between two sharp edges that follow one another counter-clockwise; at a dart all of them, from
/// its edge round to itself.
struct Sector {
  Index vertex = no_index;
  Index first_line = no_index, last_line = no_index;  ///< the sharp edges before the first and after the last face
  Index first_side = no_index, last_side = no_index;  ///< their sides within the sector
  Index begin = 0, end = 0;                           ///< its corners, in Sectors::corners
  bool banded = false;

  Index face_count() const { return end - begin; }
};

/// All sectors, vertex by vertex in ascending order, and which chains run beside a band.
struct Sectors {
  std::vector<Sector> list;
  std::vector<Index> corners;     ///< counter-clockwise, sector by sector
  std::vector<bool> side_banded;  ///< side 2i, 2i+1: the faces of line i's two half-edges

  std::span<const Index> corners_of(const Sector& sector) const {
    return std::span(corners).subspan(sector.begin, sector.face_count());
  }
  bool any_banded() const;
};

/// Finds sectors, joins their sides to strips, and bands the irregular ones.
///
/// Faces beside a regular strip share the chain's own points. That needs two faces in each sector a chain passes, one
/// at corners, three at darts: else it would cut faces in two or let them grow. An irregular strip gets a band of quads
/// between chain and faces instead, after which it is regular.
Sectors find_sectors(const Level& level, const CornerFaces& around, const TagClasses& classes);

}  // namespace croquis::subdivision
