// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "croquis/geometry/drawing.h"
#include "support/random.h"

/// Strokes as a hand would draw them, one unit a pixel.
namespace croquis::test {

/// A curve over 0..1, and how many samples are taken from it.
struct DrawnCurve {
  std::string name;
  std::function<Vec2(double)> at;
  std::size_t samples = 100;
  bool closed = false;  ///< at(1) == at(0), which isn't sampled twice
  int corners = 0;
};

/// Circles, spirals, waves, zigzags, polygons, straight lines, with few and many samples.
std::vector<DrawnCurve> drawn_curves();

Stroke sampled(const DrawnCurve& curve, const std::string& id = "s");

/// About normal in each coordinate (sum of uniform numbers).
Vec2 jitter(Random& random, double deviation);

Stroke stroke_through(const std::vector<Vec2>& places, const std::string& id, bool closed = false);

/// A circle of samples a few pixels apart.
Stroke circle(const std::string& id, const Vec2& centre, double radius, std::size_t samples = 120);

}  // namespace croquis::test
