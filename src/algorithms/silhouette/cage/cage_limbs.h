// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algorithms/silhouette/skeleton/immersion.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// A contour as it is walked with the surface on the left, measured by its length.
struct RimLine {
  std::vector<Vec2> points;
  std::vector<double> at;  ///< per point, from 0
  double length = 0;
  int side = 1;  ///< -1: walked against the contour's direction

  /// The point of a position of the contour, and the other way round.
  Index walked(Index position) const;
  Index segment_at(double place) const;  ///< the point that begins it; any place, counted around
  Vec2 place_at(double place) const;
};

std::vector<RimLine> rim_lines(const LabelledFigure& figure);

/// Where a cut across a limb ends on the rims to the left and to the right of somebody who walks along the limb.
struct LimbCut {
  double left = 0;  ///< falls along a limb, and isn't taken around
  double right = 0;
};

enum class LimbEnd { Junction, Tip, Loop };

/// A stretch of the region between junctions and tips, cut into rings.
struct CageLimb {
  Index left_rim = 0, right_rim = 0;  ///< contours
  std::array<LimbEnd, 2> ends{};      ///< of its beginning and its end; both are Loop for a limb without ends
  std::array<Index, 2> gates{no_index, no_index};  ///< 3 triangle + corner of the junction, from its own side
  std::vector<LimbCut> chords;                     ///< all of them, from end to end; those of a tip fall together
  std::vector<double> along;                       ///< per chord, counted in rings
  std::size_t rings = 0;                           ///< into how many it is to be cut; 0: too short for any
};

/// The region of a figure along its chordal axis, small branches left out: all but its junctions belongs to limbs.
struct LimbedRegion {
  std::vector<RimLine> rims;
  std::vector<CageLimb> limbs;
  std::vector<Index> junctions;  ///< triangles with three ways on …
  std::size_t triangles = 0;     ///< … of so many
};

/// @param spacing of rings, local radii
LimbedRegion limbed_region(const LabelledFigure& figure, const ImmersedTriangulation& immersed, double spacing);

/// The cuts of a limb, rings + 1 of them: evenly along it, and never two with a common end unless the limb has no
/// length on that side.
std::vector<LimbCut> ring_cuts(const LimbedRegion& region, const CageLimb& limb);

}  // namespace croquis::silhouette
