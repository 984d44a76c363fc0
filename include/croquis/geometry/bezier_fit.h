// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

/// Bézier curves of as low a degree as will do along points in space.
/// Source: Schneider 1990, "An algorithm for automatically fitting digitized curves", Graphics Gems, for the cubics;
/// higher degrees are tried before a row is divided, since every division is a corner more for who spans faces.
namespace croquis {

struct BezierFitOptions {
  double tolerance = 0;                 ///< model units, > 0: greatest distance of a point from its curve
  std::size_t most_degree = 7;          ///< 3..12
  bool divide = true;                   ///< else the row stays one curve, as near as may be
  std::optional<Vec3> start_direction;  ///< unit, along the row: the first curve leaves in it; none: free
  std::optional<Vec3> end_direction;    ///< unit, along the row: the last curve arrives in it; none: free
};

/// One curve along part of the points.
struct FittedBezier {
  std::size_t first = 0;           ///< 0-based point where it begins …
  std::size_t last = 0;            ///< … and ends, above `first`; both are met bit for bit
  std::vector<Vec3> control;       ///< 2 for a straight one
  double distance = 0;             ///< model units, the greatest of its points
  std::vector<double> parameters;  ///< 0..1, of the places nearest to its points; not always ascending
};

/// A chain of curves along points, with common tangents where one follows another. A row that no allowed degree comes
/// near is divided in its middle half. Between points nothing is asked of a curve, so its degree stays below their
/// number. About linear in the points.
/// @param points at least 2, neighbours different
std::vector<FittedBezier> fit_beziers(std::span<const Vec3> points, const BezierFitOptions& options);

/// Unit direction of a row at one of its points, of the parabola through it and the points about `reach` of arc length
/// before and after; one-sided at the ends of an open row. Zero where these are at one place.
/// @param closed the last point is followed by the first
Vec3 row_direction(std::span<const Vec3> points, std::size_t at, double reach, bool closed = false);

}  // namespace croquis
