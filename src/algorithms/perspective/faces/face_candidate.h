// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// What might be a face.
struct FaceCandidate {
  std::vector<std::vector<Index>> loops;  ///< half-edges of the graph; the outer one first, counter-clockwise about the
                                          ///< normal, holes clockwise
  std::vector<Index> edges;               ///< of the graph, ascending, each once
  bool planar = true;
  bool all_straight = true;
  Vec3 origin = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  double flatness = 0;   ///< greatest distance from the plane
  double deviation = 0;  ///< rms distance to the mean plane by the root of the area
  double cost = 0;
  Index plane = no_index;      ///< number of the plane it was found in
  std::vector<Index> regions;  ///< of that plane, ascending: what it covers of its arrangement
};

}  // namespace croquis
