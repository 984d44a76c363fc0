// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/sketches/sketch.h"

/// Sketches of parts that lie on one another as wholes: blobs, animals.
namespace croquis::test {

struct LayeredPart {
  std::vector<Vec2> outline;  ///< closed and simple, either direction
  int priority = 0;           ///< different for parts that overlap: the higher one covers the lower one
};

/// Each part is one component (chi 1).
/// @throws std::invalid_argument when a part is covered completely
Sketch layered_sketch(std::vector<LayeredPart> parts);

/// A counterclockwise circle.
std::vector<Vec2> circle_outline(const Vec2& centre, double radius, double spacing = 3);

}  // namespace croquis::test
