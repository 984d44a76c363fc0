// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {

/// Which holes are filled together. Groups only ever grow: they are joined when the surface continued from one rim
/// arrives at another.
class HoleGroups {
 public:
  explicit HoleGroups(std::size_t hole_count) : sets_(hole_count), count_(hole_count) {}

  /// The lowest hole of the group.
  Index group(Index hole) { return sets_.root(hole); }
  void merge(Index a, Index b) { sets_.unite(a, b); }

  /// Holes of each group, ascending; groups by their lowest hole.
  std::vector<std::vector<Index>> lists();

 private:
  DisjointSets sets_;
  std::size_t count_;
};

/// Beyond this angle between their faces two rims belong to different sides of something thin (radians; 100 degrees).
inline constexpr double greatest_group_angle = 1.7453292519943295;

/// Whether one sheet could hold both rims: their mean normals don't turn away from each other.
bool are_compatible(const Hole& a, const Hole& b);

/// Pairs (low, high), sorted, of holes whose boxes meet once each has grown by half its diameter in all directions.
/// L log L plus the pairs.
std::vector<std::array<Index, 2>> near_pairs(const PolyMesh& mesh, std::span<const Hole> holes);

}  // namespace croquis::hole_filling
