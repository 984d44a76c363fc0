// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "algorithms/silhouette/strokes/polyline.h"

namespace croquis::silhouette {

/// The cubic that leaves two places along their outward tangents: straight ends give handles of a third of the
/// distance, a U-turn two thirds, which is a half circle to 1 %.
std::array<Vec2, 4> completion_curve(const Vec2& a, const Vec2& tangent_a, const Vec2& b, const Vec2& tangent_b);

/// @param t 0..1
Vec2 bezier_at(const std::array<Vec2, 4>& curve, double t);

/// Samples of a cubic Bezier, evenly spread, both ends included.
Points bezier_points(const std::array<Vec2, 4>& curve, double spacing);

}  // namespace croquis::silhouette
