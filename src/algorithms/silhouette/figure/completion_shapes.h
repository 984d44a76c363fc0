// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "algorithms/silhouette/strokes/polyline.h"

namespace croquis::silhouette {

/// How a hidden piece of contour may run between its ends, besides the plain curve.
struct CompletionShape {
  double handles = 1;  ///< those of the plain curve are longer or shorter by this factor
  double reach = 0;    ///< both ends go straight on first, by so many handles of the plain curve
};

/// In the order in which they are tried: round, flatter, wider, deeper, nearly straight.
inline constexpr std::array<CompletionShape, 8> completion_shapes{
    {{1, 0}, {0.7, 0}, {0.4, 0}, {1.4, 0}, {1, 0.75}, {1, 1.5}, {1, 2.5}, {0.15, 0}}};

/// Follows after those: the plain curve, but kept behind the line that both of its ends pass behind.
inline constexpr std::uint8_t kept_behind_shape = completion_shapes.size();

/// The curve in a shape, evenly sampled, both ends included.
/// @param curve   plain, see completion_curve
/// @param stretch handles are longer by this share
Points shaped_points(const std::array<Vec2, 4>& curve, const CompletionShape& shape, double spacing,
                     double stretch = 0);

/// The same in few points, as cheap as can be.
/// @param pieces of its bent part
Points shaped_chords(const std::array<Vec2, 4>& curve, const CompletionShape& shape, int pieces);

}  // namespace croquis::silhouette
