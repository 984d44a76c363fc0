// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/geometry/drawing.h"

namespace croquis {

/// A stroke by its arc length, samples at one place taken once.
class StrokePath {
 public:
  explicit StrokePath(const Stroke& stroke);

  bool closed() const { return closed_; }
  double length() const { return lengths_.back(); }
  const std::vector<Vec2>& points() const { return points_; }

  /// The place at an arc length; of closed paths any, of open ones cut to 0..length().
  Vec2 at(double length) const;

  /// Arc lengths of places where the path turns by more than `angle` between what comes `reach` before and after.
  std::vector<double> corners(double angle, double reach) const;

  /// The points from one arc length to another, both included; from >= to runs on over the beginning of a closed path.
  std::vector<Vec2> part(double from, double to) const;

  struct Nearest {
    double length = 0;    ///< arc length
    double distance = 0;  ///< sketch units; infinite where all is shut out
  };

  /// The nearest place that isn't within `shut` of arc length around `around` (shut 0: none is shut out).
  Nearest nearest(const Vec2& point, double around = 0, double shut = 0) const;

 private:
  std::size_t segments() const { return lengths_.size() - 1; }
  const Vec2& end_of(std::size_t segment) const { return points_[(segment + 1) % points_.size()]; }
  double wrapped(double length) const;
  double along(double a, double b) const;  ///< the shorter way between two arc lengths

  std::vector<Vec2> points_;
  std::vector<double> lengths_;  ///< arc length at the beginning of each segment, and the whole
  bool closed_;
};

}  // namespace croquis
