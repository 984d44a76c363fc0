// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <Eigen/Geometry>

#include "support/sketches/sketch.h"

/// Changes after which a sketch still means the same.
namespace croquis::test {

/// Strokes and true contours; a mirror keeps surfaces on the left.
Sketch transformed(Sketch sketch, const Eigen::Affine2d& transform);
Sketch rotated(const Sketch& sketch, double radians);  ///< about the origin
Sketch scaled(const Sketch& sketch, double factor);
Sketch translated(const Sketch& sketch, const Vec2& offset);
Sketch mirrored(const Sketch& sketch);  ///< x to -x

Drawing shuffled_strokes(Drawing drawing, std::uint64_t seed);  ///< another order, ids stay with their strokes
Drawing reversed_strokes(Drawing drawing);                      ///< each drawn the other way

/// A hasty hand. Lengths in u, a thousandth of the drawing's bounding-box diagonal.
struct NoiseOptions {
  double amplitude = 1.4;       ///< standard deviation of the smooth displacement
  double wavelength = 90;       ///< shortest of that displacement
  double undershoot = 7;        ///< the most by which an end stops short of its bar
  double overshoot = 6;         ///< the most by which an end runs past its bar
  double gap = 12;              ///< length of one piece missing in the longest stroke; 0 for none
  double spacing_jitter = 0.3;  ///< of the distance between samples
};
Drawing noisy(const Drawing& drawing, std::uint64_t seed, const NoiseOptions& options = {});

/// Length of the diagonal of the bounding box of all samples.
double diagonal(const Drawing& drawing);

}  // namespace croquis::test
