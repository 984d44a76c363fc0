// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "croquis/subdivision/level.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

/// How an open chain ends.
enum class ChainEnd {
  Corner,  ///< at a vertex that stays: pinned, on the boundary, or with three and more sharp edges
  Dart     ///< within the surface
};

/// Sharp edges that follow one another, up to corners and ends.
struct EdgeChain {
  std::vector<Index> edges;     ///< in order; edge i joins vertices i and i+1
  std::vector<Index> vertices;  ///< in order; of a closed chain each once, of an open one #edges + 1
  bool closed = false;          ///< runs into itself without any corner
  std::array<ChainEnd, 2> ends = {ChainEnd::Corner, ChainEnd::Corner};  ///< of an open chain
  double least_sharpness = 0;
  double greatest_sharpness = 0;
};

/// All chains of a level, by their lowest edges. Open ones run from the end with the lower vertex, closed ones from
/// their lowest vertex towards its lower neighbour. A closed chain through one corner is open, both its ends there.
/// Linear time.
/// @param least_sharpness edges with less are no part of chains; 1 is what counts as sharp at this level
std::vector<EdgeChain> edge_chains(const Level& level, double least_sharpness = 1);

/// What can be measured of a chain. Angles in radians, 0 where faces lie flat beside one another.
struct ChainShape {
  double length = 0;
  Vec3 plane_point, plane_normal;  ///< of the plane that fits best; the normal is zero for chains along a line
  double deviation = 0;            ///< greatest distance of a vertex from that plane
  double least_bend = 0;           ///< between the faces on both sides of an edge
  double greatest_bend = 0;
  std::array<double, 2> side_bends = {0, 0};  ///< the greatest across untagged edges that end at the chain: on its left
                                              ///< and right, seen from outside along it; 0 where there are none

  /// Up to rounding of coordinates in double precision.
  bool planar() const { return deviation <= 1e-9 * length; }
};

/// Of each of the chains. @param positions #V of the level
std::vector<ChainShape> chain_shapes(const Level& level, std::span<const EdgeChain> chains,
                                     std::span<const Vec3> positions);

}  // namespace croquis::subdivision
