// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

/// Plane polylines as spans of points (#P by 2, finite). A closed one joins its last point to its first, which is not
/// repeated. All functions are linear in the points they read and write.
namespace croquis {

/// Arc length from the first point to the start of each segment, and the whole length at the end: as many as points,
/// one more when closed.
std::vector<double> arc_lengths(std::span<const Vec2> points, bool closed);

/// Sum of the segments' lengths; 0 for fewer than two points.
double length(std::span<const Vec2> points, bool closed);

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

/// Parameter in 0..1 of the place on the segment from a to b, which may have no length, that is nearest to a point.
double nearest_parameter(const Vec2& point, const Vec2& a, const Vec2& b);

}  // namespace croquis
