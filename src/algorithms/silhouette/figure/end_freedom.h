// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/junctions.h"

namespace croquis::silhouette {

/// How far ends may go on in other directions than they seem to, because the hand that drew them trembled.
class EndFreedom {
 public:
  /// @param junctions must outlive this
  /// @param line_count all lines
  EndFreedom(const Junctions& junctions, std::size_t line_count);

  /// Share of the tremble that counts where two ends are joined, 0 to 1. None where a body has two limbs: what ends
  /// twice at the same line is whole by itself, unless it fits exactly to another such piece.
  double between(const HiddenEnd& a, const HiddenEnd& b) const;

  /// The direction in which an end goes on when it is joined to what lies that way.
  static Vec2 turned(const Vec2& tangent, const Vec2& towards, double freedom);

 private:
  const Junctions& junctions_;
  std::vector<Index> bodies_;  ///< per line, see bodies_of_limbs
};

}  // namespace croquis::silhouette
