// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Convex polygons made of triangles: diagonals are taken away, the longest first, as long as what is joined stays
/// convex and has each vertex once (Hertel and Mehlhorn 1983: at most four times as many pieces as need be), and can
/// begin at a corner that sees all its other sides: the fan from there, as meshes are drawn and judged by, has no
/// triangle without area. Corners that are straight up to rounding count as convex. O(n²) at worst.
/// @param points    #P by 2
/// @param triangles counter-clockwise, indices into points
std::vector<std::vector<Index>> convex_pieces(std::span<const Vec2> points,
                                              std::span<const std::array<Index, 3>> triangles);

/// Turns a counter-clockwise polygon so that it begins at a corner that sees all its other sides.
/// @return false where it isn't convex, or no corner does
bool make_fan(std::span<const Vec2> points, std::vector<Index>& polygon);

}  // namespace croquis
