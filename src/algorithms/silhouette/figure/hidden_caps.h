// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/silhouette/strokes/junctions.h"

namespace croquis::silhouette {

/// Judges by what is drawn which lines are the outlines of limbs that are closed behind what they end at.
///
/// A limb is one line that goes round something (an ear), or two lines between the same two things (a neck). Two lines
/// from one thing, of which one goes round the other, are the two sides of a handle.
class HiddenCaps {
 public:
  /// @param lines carried on behind their bars; must outlive this, as the junctions must. O(l² n) for the l open lines.
  HiddenCaps(const std::vector<CleanLine>& lines, const Junctions& junctions);

  /// Where the surface most likely lies when a line is walked outward through an end: left (+1), right (-1).
  int outward_side(const HiddenEnd& end) const;

  /// How sure it is that the surface lies on the side that a line bends round: 1 for one that nearly closes, 0 for one
  /// whose ends are farther apart than half its length.
  double roundness(Index line) const { return roundness_[line]; }

  /// What joining two ends by a curve costs at most, since it closes a limb; infinite when it closes none.
  double highest_cost(const HiddenEnd& a, const HiddenEnd& b, const std::array<Vec2, 4>& curve) const;

 private:
  enum class Role : std::uint8_t { Any, InnerSide, OuterSide };

  void find_handles();
  double highest_cost_of_one(const HiddenEnd& a, const HiddenEnd& b, const std::array<Vec2, 4>& curve) const;
  bool close_a_limb(const HiddenEnd& a, const HiddenEnd& b, const std::array<Vec2, 4>& curve) const;
  const HiddenEnd* other_end(const HiddenEnd& end) const;

  const std::vector<CleanLine>& lines_;
  const Junctions& junctions_;
  std::vector<std::array<const HiddenEnd*, 2>> ends_;  ///< per line: at its start and end, null where it has none
  std::vector<Role> roles_;                            ///< per line: of a handle
  std::vector<double> roundness_;                      ///< per line
  std::vector<double> turning_;                        ///< per line: from its first to its last direction
};

}  // namespace croquis::silhouette
