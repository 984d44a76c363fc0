// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/perspective_drawing.h"
#include "io/svg/svg_outline.h"

namespace croquis {

PictureCubic straight_piece(const Vec2& from, const Vec2& to);

/// The cubics of a segment; arcs are cut into at most quarter turns.
std::vector<PictureCubic> cubics_of(const SvgSegment& segment, const Vec2& from);

/// Makes a stroke of one straight segment straight, and one that is parallel to an axis if it is nearly so.
void straighten(PerspectiveStroke& stroke, double tolerance);

/// Angle across the width and back, so that the angle in degrees gives the same radians again.
double degrees_of(double radians);
double radians_of(double degrees);

}  // namespace croquis
