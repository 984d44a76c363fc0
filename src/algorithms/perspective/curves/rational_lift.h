// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "croquis/geometry/camera.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/geometry/rational_cubic.h"

namespace croquis {

/// normal · X = offset. At right angles to an axis, its coordinate is met exactly.
struct LiftPlane {
  Vec3 normal = Vec3::UnitZ();
  double offset = 0;
  int axis = -1;  ///< -1 for none
};

LiftPlane axis_plane(int axis, double offset);

/// The plane through both points that is as nearly as possible at right angles to a direction.
LiftPlane plane_through(const Vec3& a, const Vec3& b, const Vec3& direction);

/// The curve of a plane that is seen exactly as a drawn cubic: rational pieces with end weights 1. One piece, unless a
/// control point lies beyond the plane's horizon. None if the curve itself gets there.
std::optional<std::vector<RationalCubic>> lifted_cubic(const PictureCubic& drawn, const LiftPlane& plane,
                                                       const Camera& camera);

/// A drawn path whose ends are moved to other places; what is between moves along in proportion.
std::vector<PictureCubic> moved_path(const PerspectiveStroke& stroke, const Vec2& start, const Vec2& end);

/// The plane that a stroke lies in, by the group that it was drawn with; its ends are at a and b.
LiftPlane plane_of_stroke(StrokeGroup group, const Vec3& a, const Vec3& b, const Camera& camera);

/// Whether a drawn curve is a straight line at any speed, to rounding.
bool is_straight(const PictureCubic& cubic);

/// Lifted pieces of each piece of a path, the ends of all at a and b bit by bit, joints at each other. None where it
/// crosses the horizon.
std::optional<std::vector<std::vector<RationalCubic>>> lifted_stroke(const PerspectiveStroke& stroke, StrokeGroup group,
                                                                     const Vec3& a, const Vec3& b,
                                                                     const Camera& camera);

/// Arc length by Gauss' rule, model units.
double arc_length(const RationalCubic& curve);

}  // namespace croquis
