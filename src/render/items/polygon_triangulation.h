// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "croquis/geometry/vector.h"

namespace croquis::render {

/// Half the sum of the cross products around a closed polygon (Newell): along its normal, as long as its area.
glm::dvec3 area_vector(std::span<const glm::dvec3> polygon);

/// Cuts a polygon of n >= 3 corners into n - 2 triangles for display, by cutting off ears.
///
/// Simple polygons, concave ones too, are covered exactly once as seen along their area vector; for one that crosses
/// itself or has no area the triangles are merely some. O(n) for convex polygons, O(n^2) usually, O(n^3) at worst.
/// @returns indices into the polygon, in its own sense of rotation
std::vector<std::array<Index, 3>> triangulate_polygon(std::span<const glm::dvec3> polygon);

}  // namespace croquis::render
