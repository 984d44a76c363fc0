// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "algorithms/silhouette/strokes/clean_line.h"

namespace croquis::silhouette {

/// A piece of a line, by the line it belongs to and its position there.
struct GridSegment {
  Vec2 a = Vec2::Zero();
  Vec2 b = Vec2::Zero();
  Index line = 0;
  Index position = 0;
};

/// Segments in the square cells of a uniform grid, to find those near a place in constant time when segments are about
/// as long as a cell. O(n) memory whatever the extent: the cell grows until there are few more cells than segments.
class SegmentGrid {
 public:
  /// @param cell   about the length of a segment, > 0
  /// @param margin segments reach this far beyond themselves, so that near misses share a cell too
  SegmentGrid(std::vector<GridSegment> segments, double cell, double margin = 0);

  const std::vector<GridSegment>& segments() const { return segments_; }

  /// Calls visit(segment, its place nearest to the given one) for every segment within reach of a place, ascending.
  template <typename Visit>
  void near_place(const Vec2& place, double reach, Visit visit) const {
    const Vec2 around = Vec2::Constant(reach);
    near_box(place - around, place + around, [&](Index i) {
      const auto& [a, b, line, position] = segments_[i];
      const Vec2 nearest = a + nearest_parameter(place, a, b) * (b - a);
      if ((place - nearest).norm() <= reach) visit(segments_[i], nearest);
    });
  }

  /// Calls visit(index of segment) for every segment whose cells meet the box, ascending, each once.
  template <typename Visit>
  void near_box(const Vec2& low, const Vec2& high, Visit visit) const {
    std::vector<Index> found;
    collect(low, high, found);
    for (const Index segment : found) visit(segment);
  }

  /// Calls visit(i, j), i < j, once for every pair of segments that share a cell, in an order that depends on the
  /// segments alone.
  template <typename Visit>
  void pairs(Visit visit) const {
    for (std::size_t cell = 0; cell + 1 < start_.size(); ++cell) {
      for (Index i = start_[cell]; i < start_[cell + 1]; ++i) {
        for (Index j = i + 1; j < start_[cell + 1]; ++j) {
          if (first_shared_cell(entries_[i], entries_[j]) == cell) visit(entries_[i], entries_[j]);
        }
      }
    }
  }

 private:
  struct Range {
    std::int64_t x0, y0, x1, y1;
  };

  std::size_t first_shared_cell(Index i, Index j) const {
    return static_cast<std::size_t>(std::max(ranges_[i].y0, ranges_[j].y0) * columns_ +
                                    std::max(ranges_[i].x0, ranges_[j].x0));
  }

  Range range(const Vec2& low, const Vec2& high) const;
  void collect(const Vec2& low, const Vec2& high, std::vector<Index>& found) const;
  void fill(double margin);

  std::vector<GridSegment> segments_;
  std::vector<Range> ranges_;
  Vec2 origin_ = Vec2::Zero();
  double cell_ = 1;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
  std::vector<Index> start_;    ///< cells + 1
  std::vector<Index> entries_;  ///< ascending within a cell
};

/// All segments of lines; `line` is the index of the line, `position` that of the segment.
std::vector<GridSegment> line_segments(const std::vector<CleanLine>& lines);

}  // namespace croquis::silhouette
