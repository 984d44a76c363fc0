// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/chip_space.h"

#include <algorithm>

namespace croquis::app {
namespace {

constexpr int chip_gap = 2;

QRect held_within(QRect place, const QRect& bounds) {
  place.moveLeft(std::max(bounds.left(), std::min(place.left(), bounds.right() - place.width() + 1)));
  place.moveTop(std::max(bounds.top(), std::min(place.top(), bounds.bottom() - place.height() + 1)));
  return place;
}

int distance_squared(const QPoint& a, const QPoint& b) {
  const QPoint way = a - b;
  return QPoint::dotProduct(way, way);
}

}  // namespace

bool ChipSpace::is_free(const QRect& place) const {
  const QRect wide = place.adjusted(-chip_gap, -chip_gap, chip_gap, chip_gap);
  return std::none_of(taken_.begin(), taken_.end(), [&](const QRect& other) { return other.intersects(wide); });
}

std::optional<QRect> ChipSpace::take(const QRect& wanted, const QRect& bounds) {
  const QRect first = held_within(wanted, bounds);
  std::optional<QRect> best;
  // The nearest free place is the wanted one, or touches others, or lies beside one at the wanted height or width.
  std::vector<int> lefts{first.left()};
  std::vector<int> tops{first.top()};
  if (!is_free(first)) {
    for (const QRect& other : taken_) {
      lefts.insert(lefts.end(), {other.left() - chip_gap - wanted.width(), other.right() + 1 + chip_gap});
      tops.insert(tops.end(), {other.top() - chip_gap - wanted.height(), other.bottom() + 1 + chip_gap});
    }
  }
  for (const int left : lefts) {
    for (const int top : tops) {
      const QRect place(QPoint(left, top), wanted.size());
      const bool nearer = !best || distance_squared(place.topLeft(), first.topLeft()) <
                                       distance_squared(best->topLeft(), first.topLeft());
      if (nearer && bounds.contains(place) && is_free(place)) best = place;
    }
  }
  if (best) taken_.push_back(*best);
  return best;
}

}  // namespace croquis::app
