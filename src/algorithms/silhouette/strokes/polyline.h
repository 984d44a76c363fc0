// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "croquis/geometry/polyline.h"
#include "croquis/geometry/predicates.h"
#include "croquis/geometry/vector.h"

/// Lines as point sequences. A place on one is a parameter: the index of its segment plus the fraction along it.
namespace croquis::silhouette {

using Points = std::vector<Vec2>;

/// A number in [-1,1) from a counter (splitmix64, Steele, Lea and Flood 2014).
inline double scattered(std::uint64_t counter) {
  std::uint64_t z = (counter + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return static_cast<double>(z >> 11) * 0x1p-52 - 1;
}

/// The place at a parameter; of a closed line parameters run on through the closing segment.
Vec2 point_at(std::span<const Vec2> points, double parameter);

/// Parameters of places spread evenly, at most `spacing` * 1.5 apart and close to `spacing`, through every fixed point.
/// Open lines keep both ends. The result is the same for both directions of drawing.
/// @param fixed ascending indices of points to keep
std::vector<double> even_parameters(std::span<const Vec2> points, bool closed, double spacing,
                                    std::span<const Index> fixed = {});

/// Those places themselves.
Points even_points(std::span<const Vec2> points, bool closed, double spacing);

/// Parameter of the place so far along an open line from its start, or back from its end; its other end where the line
/// is shorter.
double parameter_along(std::span<const Vec2> points, bool from_start, double distance);

/// Parameter of the place that is nearest to another one, within the segments from `first` to before `last`. Of a
/// closed line the last segment leads back to the first point.
double nearest_on_line(std::span<const Vec2> points, const Vec2& place, Index first, Index last);

/// Points where the line turns by more than 60 degrees within `reach` to either side: the sharpest of each bend.
std::vector<Index> corners(std::span<const Vec2> points, bool closed, double reach);

/// True when the open segments a–b and c–d cross in one inner point of both; exact.
inline bool cross_properly(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

/// Fraction along a–b where its line meets that of c–d; not finite when they are parallel.
inline double crossing_fraction(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return cross(c - a, d - c) / cross(b - a, d - c);
}

inline Vec2 nearest_on_segment(const Vec2& place, const Vec2& a, const Vec2& b) {
  return a + nearest_parameter(place, a, b) * (b - a);
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

/// Over how much of a line's end its direction is taken, in steps of the resampled line.
inline constexpr double tangent_steps = 6;

/// Outward unit direction in which an open line ends, from a quadratic fitted to its last `reach` of length.
/// Samples near the end count most, so that a tight bend further back does not turn it.
Vec2 end_tangent(std::span<const Vec2> points, bool at_start, double reach);

/// Outward unit chord over the last `reach` of length: insensitive to noise, doesn't follow bends.
Vec2 end_chord(std::span<const Vec2> points, bool at_start, double reach);

}  // namespace croquis::silhouette
