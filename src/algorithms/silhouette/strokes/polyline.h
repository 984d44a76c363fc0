// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "croquis/geometry/polyline.h"
#include "croquis/geometry/predicates.h"
#include "croquis/geometry/vector.h"

/// Lines as point sequences, and how their ends lie; more of them in croquis/geometry/polyline.h.
namespace croquis::silhouette {

using Points = std::vector<Vec2>;

/// A number in [-1,1) from a counter (splitmix64, Steele, Lea and Flood 2014).
inline double scattered(std::uint64_t counter) {
  std::uint64_t z = (counter + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return static_cast<double>(z >> 11) * 0x1p-52 - 1;
}

/// A way in which the end of a line may meet a segment.
struct EndHit {
  enum class Way { Across, Ahead, Beside };  ///< the line runs across it, heads for it, ends near it

  Way way = Way::Beside;
  double along = 0;  ///< from the end to the place: negative where that lies on the line
  Vec2 at = Vec2::Zero();
};

/// All ways in which the end of a line may meet the segment a–b; last the nearest place, however far it is.
/// @param back     the line, its end first
/// @param headings unit directions in which it may go on
/// @param reach    how far the line is looked at, back and ahead
std::vector<EndHit> end_hits(std::span<const Vec2> back, std::span<const Vec2> headings, double reach, const Vec2& a,
                             const Vec2& b);

/// How large a line is, however it is turned and sampled: the length of the straight line that is spread as widely
/// about its middle (has the same radius of gyration). A circle's is 1.2 times the diagonal of its bounding box.
double size_of(std::span<const Vec2> points, bool closed);

/// The median distance from a place that counts to the nearest other place; none where there is no other.
std::optional<double> typical_spacing(std::span<const Vec2> places, const std::vector<char>& counts);

/// One end of an open line.
inline const Vec2& end_of(std::span<const Vec2> points, bool at_start) {
  return at_start ? points.front() : points.back();
}

/// Calls visit(point, distance back from the end) until the distance reaches `reach`.
template <typename Point, typename Visit>
void walk_back(std::span<Point> points, bool at_start, double reach, Visit visit) {
  Vec2 before = end_of(points, at_start);
  double distance = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Point& point = points[at_start ? i : points.size() - 1 - i];
    distance += (point - before).norm();
    before = point;
    visit(point, distance);
    if (distance >= reach) return;
  }
}

/// Over how much of a line's end its direction is taken, in steps of the resampled line.
inline constexpr double tangent_steps = 6;

/// Outward unit direction in which an open line ends, from a quadratic fitted to its last `reach` of length.
/// Samples near the end count most, so that a tight bend further back does not turn it.
Vec2 end_tangent(std::span<const Vec2> points, bool at_start, double reach);

/// Outward unit chord over the last `reach` of length: insensitive to noise, doesn't follow bends.
Vec2 end_chord(std::span<const Vec2> points, bool at_start, double reach);

}  // namespace croquis::silhouette
