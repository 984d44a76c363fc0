// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "algorithms/silhouette/strokes/clean_line.h"

namespace croquis::silhouette {

/// Control points of a cubic Bezier curve.
using Cubic = std::array<Vec2, 4>;

/// The cubic that leaves two places along their outward tangents: straight ends give handles of a third of the
/// distance, a U-turn two thirds, which is a half circle to 1 %.
Cubic completion_curve(const Vec2& a, const Vec2& tangent_a, const Vec2& b, const Vec2& tangent_b);

/// How a hidden piece of contour may run between its ends, besides the plain curve.
struct CompletionShape {
  double handles = 1;        ///< those of the plain curve are longer or shorter by this factor
  double reach = 0;          ///< both ends go straight on first, by so many handles of the plain curve
  bool kept_behind = false;  ///< it stays behind the line that both of its ends pass behind
};

/// In the order in which they are tried: round, flatter, wider, deeper, nearly straight; then the plain curve, kept
/// behind its bar.
inline constexpr std::array<CompletionShape, 9> completion_shapes{
    {{1, 0}, {0.7, 0}, {0.4, 0}, {1.4, 0}, {1, 0.75}, {1, 1.5}, {1, 2.5}, {0.15, 0}, {1, 0, true}}};
inline constexpr std::uint8_t kept_behind_shape = completion_shapes.size() - 1;

/// The curve in a shape, as a polyline of so many pieces for its bent part; it isn't kept behind anything.
Points completion_chords(const Cubic& curve, const CompletionShape& shape, int pieces);

/// The curve in a shape, evenly sampled, both ends included.
/// @param bar what it is kept behind, with its surface on the left (+1) or right (-1)
/// O(#P) samples of the curve, each by all of the bar where it is kept behind that.
Points completion_points(const Cubic& curve, const CompletionShape& shape, double spacing, const CleanLine& bar,
                         int bar_side);

}  // namespace croquis::silhouette
