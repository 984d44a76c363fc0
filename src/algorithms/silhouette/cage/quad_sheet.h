// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "algorithms/silhouette/cage/cage_limbs.h"

namespace croquis::silhouette {

/// A vertex of a sheet of quads.
struct QuadVertex {
  Vec2 place = Vec2::Zero();
  Index rim = no_index;     ///< the contour that it lies on; no_index inside
  double at = 0;            ///< on that rim
  Index before = no_index;  ///< inside: a vertex of a lower number, from which a straight line to it stays in the sheet
};

/// The immersed region cut into quads. A cut across a limb has five vertices, so that a ring around it has eight.
struct QuadSheet {
  std::vector<QuadVertex> vertices;
  std::vector<std::array<Index, 4>> faces;  ///< counter-clockwise in the plane
  std::size_t tips = 0;
};

/// Limbs are rows of four quads; at a tip the last two meet. A junction is a polygon whose sides are its limbs' last
/// cuts, with four quads per corner; junctions with hardly anything between them are one.
QuadSheet quad_sheet(const LimbedRegion& region);

}  // namespace croquis::silhouette
