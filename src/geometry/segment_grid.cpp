// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/segment_grid.h"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/predicates.h"

namespace croquis {
namespace {

/// An end of one of two segments that is nearer than `reach` to the other one.
std::optional<Vec2> touching_end(const GridSegment& a, const GridSegment& b, double reach) {
  const bool neighbours = a.line == b.line && (a.b == b.a || b.b == a.a);
  if (neighbours || !(reach > 0)) return std::nullopt;
  for (const auto& [end, other] : {std::pair(a.a, &b), {a.b, &b}, {b.a, &a}, {b.b, &a}}) {
    if ((nearest_on_segment(end, other->a, other->b) - end).norm() < reach) return end;
  }
  return std::nullopt;
}

}  // namespace

SegmentGrid::SegmentGrid(std::vector<GridSegment> segments, double cell, double margin)
    : segments_(std::move(segments)), cell_(cell) {
  Eigen::AlignedBox2d box;
  for (const GridSegment& segment : segments_) box.extend(segment.a).extend(segment.b);
  if (box.isEmpty()) box.extend(Vec2(0, 0));
  origin_ = box.min();
  const Vec2 extent = box.sizes();
  const double most_cells = 4.0 * static_cast<double>(segments_.size()) + 16;
  while ((extent.x() / cell_ + 1) * (extent.y() / cell_ + 1) > most_cells) cell_ *= 2;
  columns_ = static_cast<std::int64_t>(extent.x() / cell_) + 1;
  rows_ = static_cast<std::int64_t>(extent.y() / cell_) + 1;
  cells_.resize(static_cast<std::size_t>(columns_ * rows_));
  const Vec2 reach = Vec2::Constant(margin);
  for (Index i = 0; i < segments_.size(); ++i) {
    const auto& [a, b, line, position] = segments_[i];
    for_cells(range(a.cwiseMin(b) - reach, a.cwiseMax(b) + reach), [&](std::size_t k) { cells_[k].push_back(i); });
  }
}

SegmentGrid::Range SegmentGrid::range(const Vec2& low, const Vec2& high) const {
  const auto index = [this](double value, double origin, std::int64_t count) {
    const double cell = std::floor((value - origin) / cell_);
    return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
  };
  return {index(low.x(), origin_.x(), columns_), index(low.y(), origin_.y(), rows_),
          index(high.x(), origin_.x(), columns_), index(high.y(), origin_.y(), rows_)};
}

std::optional<SegmentGrid::Place> SegmentGrid::nearest(const Vec2& place, double reach) const {
  std::optional<Place> best;
  near_place(place, reach, [&](const GridSegment& segment, const Vec2& at) {
    const double distance = (at - place).norm();
    if (distance < (best ? best->distance : reach)) best = {segment, at, distance};
  });
  return best;
}

std::vector<SegmentContact> find_contacts(const SegmentGrid& grid, double reach) {
  std::vector<SegmentContact> found;
  const auto compare = [&](const GridSegment& a, const GridSegment& b) {
    if (segments_cross(a.a, a.b, b.a, b.b)) {
      const double along_a = crossing_fraction(a.a, a.b, b.a, b.b), along_b = crossing_fraction(b.a, b.b, a.a, a.b);
      found.push_back({a, b, a.a + along_a * (a.b - a.a), orientation(a.a, a.b, b.b), along_a, along_b});
    } else if (const std::optional<Vec2> at = touching_end(a, b, reach)) {
      found.push_back({a, b, *at});
    }
  };
  const std::vector<GridSegment>& segments = grid.segments();
  for (Index i = 0; i < segments.size(); ++i) {
    const Vec2 low = segments[i].a.cwiseMin(segments[i].b).array() - reach;
    const Vec2 high = segments[i].a.cwiseMax(segments[i].b).array() + reach;
    grid.near_box(low, high, [&](Index j) {
      if (j > i) compare(segments[i], segments[j]);
    });
  }
  return found;
}

}  // namespace croquis
