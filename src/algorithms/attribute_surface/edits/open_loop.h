// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "croquis/attribute_surface/loop_search.h"

namespace croquis {

/// Which ends of curves are at one place: at the same node, or no farther apart than a tolerance.
class CurveEnds {
 public:
  CurveEnds(const AttributeNetwork& network, const std::vector<Index>& curves, double tolerance);

  /// The number of the place where the curve at that position of the list begins or ends: below twice as many as there
  /// are curves, that of the first end at the place.
  std::size_t of(std::size_t position, bool last) const { return places_[2 * position + (last ? 1 : 0)]; }

 private:
  std::vector<Index> places_;
};

/// The face whose loop has these curves, in any order, or none.
std::optional<Index> face_with_loop(const AttributeNetwork& network, const std::vector<Index>& curves);

/// The loop walked along the other way, begun with the same curve.
void turn_loop_round(SortedLoop& loop);

/// How many sides of faces run against those of a loop, as neighbours should, less those that run along with them.
int turn_of_neighbours(const AttributeNetwork& network, const std::vector<AttributeSide>& sides);

}  // namespace croquis
