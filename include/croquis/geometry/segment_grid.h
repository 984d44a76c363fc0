// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "croquis/geometry/polyline.h"
#include "croquis/geometry/vector.h"

/// Segments of plane lines, and where they come near to one another.
namespace croquis {

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
  struct Place {
    GridSegment segment;
    Vec2 at = Vec2::Zero();
    double distance = 0;
  };

  /// @param cell   about the length of a segment, > 0
  /// @param margin segments reach this far beyond themselves
  SegmentGrid(std::vector<GridSegment> segments, double cell, double margin = 0);

  const std::vector<GridSegment>& segments() const { return segments_; }

  /// Calls visit(segment, its place nearest to the given one) for every segment within reach of a place, ascending.
  template <typename Visit>
  void near_place(const Vec2& place, double reach, Visit visit) const {
    const Vec2 around = Vec2::Constant(reach);
    near_box(place - around, place + around, [&](Index i) {
      const Vec2 nearest = nearest_on_segment(place, segments_[i].a, segments_[i].b);
      if ((place - nearest).norm() <= reach) visit(segments_[i], nearest);
    });
  }

  /// Calls visit(index of segment) for every segment whose cells meet the box, ascending, each once.
  template <typename Visit>
  void near_box(const Vec2& low, const Vec2& high, Visit visit) const {
    std::vector<Index> found;
    for_cells(range(low, high),
              [&](std::size_t cell) { found.insert(found.end(), cells_[cell].begin(), cells_[cell].end()); });
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const Index segment : found) visit(segment);
  }

  /// The place on a segment that is nearest to another place, where there is one nearer than `reach`.
  std::optional<Place> nearest(const Vec2& place, double reach) const;

 private:
  struct Range {
    std::int64_t x0, y0, x1, y1;
  };

  template <typename Visit>
  void for_cells(const Range& cells, Visit visit) const {
    for (std::int64_t y = cells.y0; y <= cells.y1; ++y) {
      for (std::int64_t x = cells.x0; x <= cells.x1; ++x) visit(static_cast<std::size_t>(y * columns_ + x));
    }
  }

  Range range(const Vec2& low, const Vec2& high) const;

  std::vector<GridSegment> segments_;
  Vec2 origin_ = Vec2::Zero();
  double cell_ = 1;
  std::int64_t columns_ = 1;
  std::int64_t rows_ = 1;
  std::vector<std::vector<Index>> cells_;  ///< segments, ascending
};

/// Adds all segments of a line, which has `points`, and is closed unless its `closed` says otherwise; `line` is the
/// number given, `position` that of the segment.
template <typename Line>
void add_segments(const Line& line, Index number, std::vector<GridSegment>& segments) {
  const auto& points = line.points;
  std::size_t count = points.size();
  if constexpr (requires { line.closed; }) count -= line.closed ? 0U : 1U;
  for (Index i = 0; i < count; ++i) segments.push_back({points[i], points[(i + 1) % points.size()], number, i});
}

/// The segments of all lines of a list, by their indices.
template <typename Line>
std::vector<GridSegment> segments_of(const std::vector<Line>& lines) {
  std::vector<GridSegment> segments;
  for (Index line = 0; line < lines.size(); ++line) add_segments(lines[line], line, segments);
  return segments;
}

/// Those of one line or several, numbered as they are given.
template <typename... Line>
std::vector<GridSegment> segments_of_lines(const Line&... lines) {
  std::vector<GridSegment> segments;
  Index number = 0;
  (add_segments(lines, number++, segments), ...);
  return segments;
}

/// Where two segments cross or touch.
struct SegmentContact {
  GridSegment a;  ///< comes before b
  GridSegment b;
  Vec2 at = Vec2::Zero();
  int sign = 0;           ///< of cross(direction of a, direction of b) where they cross properly; 0 where they touch
  double fraction_a = 0;  ///< along a, of a crossing
  double fraction_b = 0;

  bool crosses() const { return sign != 0; }
};

/// Where the segments of a grid cross properly (exact predicates) or touch, in the order of the segments. Neighbours on
/// one line don't touch there.
/// @param reach segments touch that come nearer than this
std::vector<SegmentContact> find_contacts(const SegmentGrid& grid, double reach = 0);

}  // namespace croquis
