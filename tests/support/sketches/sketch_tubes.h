// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "support/sketches/sketch.h"

/// Sketches of tubes round plane centre lines: knots, links, snakes, bars.
namespace croquis::test {

/// One tube. The functions take a parameter in [0,1] and must be smooth a little beyond it; those of a closed strand
/// have period 1. The radius must stay below the centre line's radius of curvature.
struct TubeStrand {
  std::function<Vec2(double)> centre;
  std::function<double(double)> radius;
  std::function<double(double)> height;  ///< where two pieces cross, the higher one is in front
  bool closed = true;                    ///< else it ends in round caps
};

struct TubeOptions {
  double spacing = 3;  ///< between samples of a stroke, sketch units
};

/// A closed strand gives two contours (chi 0), an open one a single contour (chi 1); each strand is one component.
/// @throws std::logic_error when the heights contradict each other
Sketch tube_sketch(const std::vector<TubeStrand>& strands, const TubeOptions& options = {});

/// A straight open strand from a to b (the centres of its caps).
TubeStrand bar(const Vec2& a, const Vec2& b, double radius, std::function<double(double)> height);

/// A circular closed strand; parameter 0 is on the right, counterclockwise.
TubeStrand ring(const Vec2& centre, double ring_radius, double radius, std::function<double(double)> height);

/// An open strand through points (natural cubic spline over chord length).
TubeStrand limb(const std::vector<Vec2>& through, const std::vector<double>& radii, double height);

/// The outline of an open strand, counterclockwise.
std::vector<Vec2> tube_outline(const TubeStrand& strand, double spacing = 3);

}  // namespace croquis::test
