// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cstdint>

#include "algorithms/silhouette/drawing_reading.h"
#include "algorithms/silhouette/sampling/planar_walk.h"

namespace croquis::silhouette {
namespace {

// Drawings with symmetries put samples exactly on other lines. So small a displacement (of a step) can't be seen and
// leaves no three points on a line.
constexpr double displacement = 1e-7;

/// A start for a line's counter that no other line shares, and that stays the same while other lines change: then the
/// parts of the drawing made of those don't.
std::uint64_t seed_of(const CleanLine& line) {
  std::uint64_t seed = line.points.size();
  for (const Vec2& point : {line.points.front(), line.points[line.points.size() / 2], line.points.back()}) {
    for (const double coordinate : {point.x(), point.y()}) {
      seed = seed * 0x100000001b3U + std::bit_cast<std::uint64_t>(coordinate);
      seed = (seed ^ (seed >> 29)) * 0xbf58476d1ce4e5b9U;
    }
  }
  return seed;
}

}  // namespace

void bring_into_general_position(std::vector<CleanLine>& lines, double step) {
  for (CleanLine& line : lines) {
    std::uint64_t counter = seed_of(line);
    for (Vec2& point : line.points) {
      point.x() += displacement * step * scattered(counter++);
      point.y() += displacement * step * scattered(counter++);
    }
  }
}

}  // namespace croquis::silhouette
