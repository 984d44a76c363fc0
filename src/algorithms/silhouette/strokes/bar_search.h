// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"
#include "algorithms/silhouette/strokes/segment_grid.h"

namespace croquis::silhouette {

/// Where the end of a line meets another line.
struct BarHit {
  double along = 0;  ///< arc length from the end: negative on the line (overshoot), positive ahead of it
  Index bar = 0;
  double parameter = 0;  ///< on the bar
  Vec2 at = Vec2::Zero();
};

/// How far to look from an end.
struct EndReach {
  double most_back = 0;          ///< along the line at most; less where hands don't miss by so much
  double factor = 1;             ///< of what hands miss by
  std::vector<Index> elsewhere;  ///< strokes that the end doesn't pass behind
};

/// Looks for the bar that a line's end stops at.
class BarSearch {
 public:
  /// @param lines must outlive the search and stay as they are
  BarSearch(const std::vector<CleanLine>& lines, const DrawingScale& scale);

  /// The bar of an end: what the last bit of the line crosses, else what a ray along the end's tangent
  /// meets within reach, else the nearest line within reach (an end that meets its bar almost tangentially).
  std::optional<BarHit> find(Index line, bool at_start, const EndReach& wanted) const;

 private:
  struct Probe;

  double reach(Index line, Index bar) const;
  Probe probe(Index line, bool at_start, const EndReach& wanted) const;
  std::vector<BarHit> hits(const Probe& probe) const;
  std::optional<BarHit> nearest(const Probe& probe) const;
  bool is_left_out(const Probe& probe, const GridSegment& segment) const;
  bool is_own_end(const Probe& probe, const GridSegment& segment) const;
  double distance_to_open_end(Index line, double parameter) const;

  const std::vector<CleanLine>& lines_;
  const DrawingScale& scale_;
  double largest_ = 0;  ///< size of any line
  SegmentGrid grid_;
};

}  // namespace croquis::silhouette
