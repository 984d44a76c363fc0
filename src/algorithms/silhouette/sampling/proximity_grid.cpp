// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/proximity_grid.h"

#include <algorithm>
#include <cmath>

namespace croquis::silhouette {
namespace {

/// More cells than this cost more memory than they save time: the cells of a huge drawing grow instead.
constexpr double max_cells = 1 << 20;

double squared_distance(const Vec2& a, const Vec2& b, const Vec2& place) {
  const Vec2 along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0 ? std::clamp((place - a).dot(along) / length, 0.0, 1.0) : 0;
  return (a + t * along - place).squaredNorm();
}

}  // namespace

ProximityGrid::ProximityGrid(const Vec2& low, const Vec2& high, double reach) : low_(low), reach_(reach) {
  const Vec2 size = high - low;
  cell_ = std::max(2 * reach, std::sqrt(std::max(size.x() * size.y(), 0.0) / max_cells));
  cell_ = std::max(cell_, size.maxCoeff() / max_cells);
  columns_ = static_cast<std::int64_t>(size.x() / cell_) + 1;
  rows_ = static_cast<std::int64_t>(size.y() / cell_) + 1;
  first_.assign(static_cast<std::size_t>(columns_ * rows_), -1);
}

std::int64_t ProximityGrid::column(double x) const {
  return std::clamp(static_cast<std::int64_t>(std::floor((x - low_.x()) / cell_)), std::int64_t{0}, columns_ - 1);
}

std::int64_t ProximityGrid::row(double y) const {
  return std::clamp(static_cast<std::int64_t>(std::floor((y - low_.y()) / cell_)), std::int64_t{0}, rows_ - 1);
}

void ProximityGrid::add(const Vec2& a, const Vec2& b) {
  const Vec2 least = a.cwiseMin(b).array() - reach_;
  const Vec2 greatest = a.cwiseMax(b).array() + reach_;
  for (std::int64_t y = row(least.y()); y <= row(greatest.y()); ++y) {
    for (std::int64_t x = column(least.x()); x <= column(greatest.x()); ++x) {
      std::int64_t& first = first_[static_cast<std::size_t>(y * columns_ + x)];
      entries_.push_back({a, b, first});
      first = static_cast<std::int64_t>(entries_.size()) - 1;
    }
  }
}

bool ProximityGrid::any_within(const Vec2& place, double distance) const {
  std::int64_t entry = first_[static_cast<std::size_t>(row(place.y()) * columns_ + column(place.x()))];
  for (; entry >= 0; entry = entries_[static_cast<std::size_t>(entry)].next) {
    const Entry& item = entries_[static_cast<std::size_t>(entry)];
    if (squared_distance(item.a, item.b, place) < distance * distance) return true;
  }
  return false;
}

}  // namespace croquis::silhouette
