// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algorithms/subdivision/refinement/tag_classes.h"

namespace croquis::subdivision {

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
