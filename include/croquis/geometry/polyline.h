// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

/// Plane polylines as spans of points (#P by 2, finite). A closed one joins its last point to its first, which is not
/// repeated. All functions are linear in the points they read and write.
namespace croquis {

/// Sum of the segments' lengths; 0 for fewer than two points.
double length(std::span<const Vec2> points, bool closed);

/// Points at equal distances along the polyline: max(1, round(length / step)) segments, at least 3 when closed.
///
/// The first point stays, and the last of an open polyline; corners between samples are cut. Walking the other way
/// gives the same points. A polyline without a length gives its first point alone, an empty one nothing.
/// @param step wanted distance, > 0
/// @throws Error (E_PARAMETER) for a step that is not positive or asks for more than 1e8 points
std::vector<Vec2> resample(std::span<const Vec2> points, bool closed, double step);

/// Fairing without shrinking: each pass moves every point by lambda, then by mu, towards the middle of its neighbours.
struct TaubinOptions {
  int passes = 10;
  double lambda = 0.5;  ///< 0..1, the smoothing step
  double mu = -0.53;    ///< below -lambda, the step back that keeps the size

  /// Points where the line turns by at least this angle (radians, before smoothing) stay; infinite for none.
  double corner_angle = std::numeric_limits<double>::infinity();
  std::vector<bool> fixed = {};  ///< #P, further points that stay; empty for none
};

/// The ends of an open polyline always stay. Source: Taubin 1995, "A signal processing approach to fair surface
/// design", section 3, with equal weights: meant for points at about equal distances.
/// @throws Error (E_PARAMETER) when `fixed` is neither empty nor of #P
std::vector<Vec2> taubin_smooth(std::span<const Vec2> points, bool closed, const TaubinOptions& options = {});

/// Area enclosed by a closed polyline, counter-clockwise positive, overlaps counted as often as they are wound around.
double signed_area(std::span<const Vec2> polygon);

/// How often a closed polyline winds around a point, counter-clockwise positive; decided exactly. A point on the line
/// counts as on one of its sides.
int winding_number(std::span<const Vec2> polygon, const Vec2& point);

/// Distance from a point to the segment from a to b, which may have no length.
double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b);

/// A place on a polyline.
struct PolylinePoint {
  std::size_t segment = 0;  ///< from this point to the next
  double parameter = 0;     ///< 0..1 along the segment
  Vec2 position = Vec2::Zero();
  double distance = std::numeric_limits<double>::infinity();  ///< from the point asked for
};

/// The place nearest to a point, the first of several. An empty polyline leaves the distance infinite; a single point
/// is a segment without a length.
PolylinePoint closest_point(std::span<const Vec2> points, bool closed, const Vec2& point);

}  // namespace croquis
