// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/geometry/vector.h"

namespace croquis::hole_filling {

/// A plane with right-handed axes: u × v = normal, all unit.
struct RimPlane {
  Vec3 centre, u, v, normal;

  Vec2 project(const Vec3& point) const { return {u.dot(point - centre), v.dot(point - centre)}; }
};

/// The plane nearest to the edges of a closed polygon in the sense of squared distances weighted by length, around
/// whose normal it runs counter-clockwise.
RimPlane plane_of_rim(std::span<const Vec3> polygon);

}  // namespace croquis::hole_filling
