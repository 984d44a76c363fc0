// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/tools/strokes/stroke_fit.h"

namespace croquis {

/// One cubic through a piece of a point list.
struct FittedPiece {
  std::size_t first = 0;           ///< 0-based point at its beginning …
  std::size_t last = 0;            ///< … and at its end, after `first`
  CubicSegment cubic;              ///< passes through both
  std::vector<double> parameters;  ///< 0..1, of each point from first to last
};

/// Fits a chain of cubics with common tangents to points (at least two, neighbours distinct).
/// @param begin, end   unit directions at the first and the last point, both along the line
/// @param reach        arc length over which tangents at inner joints are taken
/// @param tolerance    largest RMS distance of each piece's points; no point may miss by more than three times that
std::vector<FittedPiece> fit_cubics(std::span<const Vec2> points, const Vec2& begin, const Vec2& end, double reach,
                                    double tolerance);

/// Unit direction at an inner point: of the parabola through it and the places about `reach` before and after.
Vec2 tangent_within(std::span<const Vec2> points, std::size_t at, double reach);

/// Unit direction at the first point, by a parabola through two more.
Vec2 tangent_at_begin(std::span<const Vec2> points, double reach);

/// The parameter of the place nearest to a point, from a start near it (Newton). In 0..1.
double nearest_on_cubic(const CubicSegment& cubic, const Vec2& point, double start);

}  // namespace croquis
