// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/render/line_item.h"

namespace croquis::render {

/// An edge in a colour and a width of its own.
struct StyledEdge {
  std::array<Index, 2> vertices = {no_index, no_index};
  Color color = {40, 36, 42, 255};
  float width = 3;  ///< pixels of a screen with `RenderOptions::pixel_ratio` 1, in (0, 128]
};

/// Edges of a mesh as one shape in two draw calls: thick, round, seen whole where the surface shows them, meeting in
/// the middle where colours differ. Any pairs of vertices will do, so edges of a cage can be shown on its result, too.
///
/// Made from positions alone: cheap enough for every event of a drag, as long as it isn't most of a large mesh.
/// @param positions #V by 3, model units
/// @param depth of LineItem: what covers the edges
/// @throws Error (E_INDEX, E_NOT_FINITE, malformed) naming each edge that can't be drawn
/// O(edges).
LineItemPtr make_edge_item(std::span<const Vec3> positions, std::span<const StyledEdge> edges,
                           LineDepth depth = LineDepth::OnSurface);

}  // namespace croquis::render
