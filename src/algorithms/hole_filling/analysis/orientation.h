// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/surface_view.h"

namespace croquis::hole_filling {

/// Of each part that edges of two triangles join, turns the minority of its triangles (of two halves the one
/// without the lowest triangle) and numbers the components. Fills component, component_count, one_sided_components and
/// the `turned` flags; rewrites triangles and opposite where triangles are turned. Linear.
/// @param nonmanifold_corners see EdgePairing: they join components but decide no orientation
void orient_and_number(SurfaceView& view, std::span<const std::array<Index, 2>> nonmanifold_corners,
                       Progress& progress);

}  // namespace croquis::hole_filling
