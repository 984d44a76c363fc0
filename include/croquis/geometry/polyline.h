// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

/// Plane polylines as spans of points (#P by 2, finite). A closed one joins its last point to its first, which is not
/// repeated. A place on one is a parameter: the index of its segment plus the fraction along it. All functions are
/// linear in the points they read and write.
namespace croquis {

/// Arc length from the first point to the start of each segment, and the whole length at the end: as many as points,
/// one more when closed.
std::vector<double> arc_lengths(std::span<const Vec2> points, bool closed);

/// Sum of the segments' lengths; 0 for fewer than two points.
double length(std::span<const Vec2> points, bool closed);

/// The place at a parameter; of a closed line parameters run on through the closing segment.
Vec2 point_at(std::span<const Vec2> points, double parameter);

/// Parameters of places spread evenly, at most `spacing` * 1.5 apart and close to `spacing`, through every fixed point.
/// Open lines keep both ends. The result is the same for both directions of drawing.
/// @param fixed ascending indices of points to keep
std::vector<double> even_parameters(std::span<const Vec2> points, bool closed, double spacing,
                                    std::span<const Index> fixed = {});

/// Those places themselves.
std::vector<Vec2> even_points(std::span<const Vec2> points, bool closed, double spacing);

/// Parameter of the place so far along an open line from its start, or back from its end; its other end where the line
/// is shorter.
double parameter_along(std::span<const Vec2> points, bool from_start, double distance);

/// Parameter of the place that is nearest to another one, within the segments from `first` to before `last`. Of a
/// closed line the last segment leads back to the first point.
double nearest_on_line(std::span<const Vec2> points, const Vec2& place, Index first, Index last);

/// Points where an evenly sampled line turns by more than an angle (radians) within `reach` to either side: the
/// sharpest of each bend.
std::vector<Index> corners_of(std::span<const Vec2> points, bool closed, double reach, double angle);

/// Fairing without shrinking: each pass moves every point by lambda, then by mu, towards the middle of its neighbours.
struct TaubinOptions {
  int passes = 10;
  double lambda = 0.5;           ///< 0..1, the smoothing step
  double mu = -0.52;             ///< below -lambda, the step back that keeps the size
  std::vector<bool> fixed = {};  ///< #P, points that stay; empty for none
};

/// The ends of an open polyline always stay. Source: Taubin 1995, "A signal processing approach to fair surface
/// design", section 3, with equal weights: meant for points at about equal distances.
/// @throws Error (E_PARAMETER) when `fixed` is neither empty nor of #P
std::vector<Vec2> taubin_smooth(std::span<const Vec2> points, bool closed, const TaubinOptions& options = {});

/// Area enclosed by a closed polyline, counter-clockwise positive, overlaps counted as often as they are wound around.
double signed_area(std::span<const Vec2> polygon);

/// How often a closed polyline goes round a place that isn't on it, counter-clockwise positive. Exact.
int winding_number(std::span<const Vec2> polygon, const Vec2& place);

/// Whether a place lies inside a closed polyline, by the parity of crossings.
inline bool encloses(std::span<const Vec2> polygon, const Vec2& place) {
  return winding_number(polygon, place) % 2 != 0;
}

/// Parameter in 0..1 of the place on the segment from a to b, which may have no length, that is nearest to a point.
double nearest_parameter(const Vec2& point, const Vec2& a, const Vec2& b);

inline Vec2 nearest_on_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
  return a + nearest_parameter(point, a, b) * (b - a);
}

/// In space; the segment may have no length.
inline Vec3 nearest_on_segment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length = along.squaredNorm();
  return length > 0 ? Vec3(a + std::clamp((point - a).dot(along) / length, 0.0, 1.0) * along) : a;
}

/// Fraction along a–b where its line meets that of c–d; not finite when they are parallel.
inline double crossing_fraction(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return cross(c - a, d - c) / cross(b - a, d - c);
}

}  // namespace croquis
