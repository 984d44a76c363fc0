// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/silhouette/strokes/junctions.h"
#include "algorithms/silhouette/strokes/segment_grid.h"

namespace croquis::silhouette {

/// Judges hidden pieces of contour by what is drawn alone, before anything is labelled.
///
/// What is drawn has nothing in front; so a hidden piece passes behind every line that it crosses, and one surface more
/// or less is in front of it from there on. Behind its bar it starts with one.
class DrawnCover {
 public:
  /// @param lines   carried on behind their bars; must outlive this
  DrawnCover(const std::vector<CleanLine>& lines, const Junctions& junctions);

  /// How many surfaces are missing in front of a piece where it lies in the open; 0 if it is covered all along. Near
  /// O(#P).
  /// @param curve from one place behind a bar to another
  int missing(const Points& curve) const;

 private:
  SegmentGrid grid_;
  std::vector<int> sides_;  ///< per line: where its surface lies, 0 where an open one's isn't known
};

/// Where the surface of a line most likely lies that is no bar: a line that goes round something bounds it.
int likely_side(const CleanLine& line);

}  // namespace croquis::silhouette
