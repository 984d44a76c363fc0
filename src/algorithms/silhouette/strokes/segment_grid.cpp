// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/segment_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace croquis::silhouette {

SegmentGrid::SegmentGrid(std::vector<GridSegment> segments, double cell, double margin)
    : segments_(std::move(segments)), cell_(cell) {
  Vec2 high = Vec2::Zero();
  if (!segments_.empty()) origin_ = high = segments_.front().a;
  for (const GridSegment& segment : segments_) {
    origin_ = origin_.cwiseMin(segment.a).cwiseMin(segment.b);
    high = high.cwiseMax(segment.a).cwiseMax(segment.b);
  }
  const Vec2 extent = high - origin_;
  const double most_cells = 4.0 * static_cast<double>(segments_.size()) + 16;
  while ((extent.x() / cell_ + 1) * (extent.y() / cell_ + 1) > most_cells) cell_ *= 2;
  columns_ = static_cast<std::int64_t>(extent.x() / cell_) + 1;
  rows_ = static_cast<std::int64_t>(extent.y() / cell_) + 1;
  fill(margin);
}

SegmentGrid::Range SegmentGrid::range(const Vec2& low, const Vec2& high) const {
  const auto index = [this](double value, double origin, std::int64_t count) {
    const double cell = std::floor((value - origin) / cell_);
    return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
  };
  return {index(low.x(), origin_.x(), columns_), index(low.y(), origin_.y(), rows_),
          index(high.x(), origin_.x(), columns_), index(high.y(), origin_.y(), rows_)};
}

void SegmentGrid::fill(double margin) {
  start_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  ranges_.reserve(segments_.size());
  const Vec2 reach = Vec2::Constant(margin);
  for (const GridSegment& segment : segments_) {
    ranges_.push_back(range(segment.a.cwiseMin(segment.b) - reach, segment.a.cwiseMax(segment.b) + reach));
  }
  const auto for_cells = [this](const Range& cells, auto&& visit) {
    for (std::int64_t y = cells.y0; y <= cells.y1; ++y) {
      for (std::int64_t x = cells.x0; x <= cells.x1; ++x) visit(static_cast<std::size_t>(y * columns_ + x));
    }
  };
  for (const Range& cells : ranges_) {
    for_cells(cells, [this](std::size_t cell) { ++start_[cell + 1]; });
  }
  for (std::size_t cell = 1; cell < start_.size(); ++cell) start_[cell] += start_[cell - 1];
  entries_.resize(start_.back());
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (Index i = 0; i < segments_.size(); ++i) {
    for_cells(ranges_[i], [&](std::size_t cell) { entries_[next[cell]++] = i; });
  }
}

void SegmentGrid::collect(const Vec2& low, const Vec2& high, std::vector<Index>& found) const {
  const Range cells = range(low, high);
  for (std::int64_t y = cells.y0; y <= cells.y1; ++y) {
    for (std::int64_t x = cells.x0; x <= cells.x1; ++x) {
      const auto cell = static_cast<std::size_t>(y * columns_ + x);
      found.insert(found.end(), entries_.begin() + start_[cell], entries_.begin() + start_[cell + 1]);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

std::vector<GridSegment> line_segments(const std::vector<CleanLine>& lines) {
  std::vector<GridSegment> segments;
  for (Index line = 0; line < lines.size(); ++line) {
    const Points& points = lines[line].points;
    for (Index i = 0; i < lines[line].segment_count(); ++i) {
      segments.push_back({points[i], points[(i + 1) % points.size()], line, i});
    }
  }
  return segments;
}

}  // namespace croquis::silhouette
