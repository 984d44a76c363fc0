// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/drawing.h"
#include "support/random.h"

/// Strokes as paths that can be cut, lengthened and shaken.
namespace croquis::test {

std::vector<Vec2> points_of(const Stroke& stroke);
void set_points(Stroke& stroke, const std::vector<Vec2>& points);

/// Of an open polyline.
double path_length(const std::vector<Vec2>& points);

/// The place at a distance along an open polyline; beyond an end straight on.
Vec2 path_place(const std::vector<Vec2>& points, double distance);

/// The part of an open polyline between two distances, either of which may lie beyond its ends.
std::vector<Vec2> path_part(const std::vector<Vec2>& points, double from, double to);

/// A displacement that varies slowly along a stroke and, on a closed one, comes round to itself.
class Wobble {
 public:
  /// @param amplitude  standard deviation of the displacement
  /// @param wavelength shortest of its waves
  Wobble(Random& random, double length, double amplitude, double wavelength);

  Vec2 at(double distance) const;

 private:
  struct Wave {
    double size;
    double phase;
  };
  double length_;
  double scale_ = 0;
  std::vector<Wave> x_;
  std::vector<Wave> y_;
};

}  // namespace croquis::test
