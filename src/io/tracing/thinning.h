// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/tracing/pixel_grid.h"

namespace croquis::tracing {

/// What distances between pixels are counted in: a step to the side is 3, a diagonal one 4.
inline constexpr int pixel_step = 3;

/// The distance of each pixel of the mask from the nearest one outside; what lies beyond the border is outside.
/// Source: Borgefors 1986, "Distance transformations in digital images".
PixelGrid<int> distances_to_outside(const Mask& mask);

/// The middle lines of the mask, one pixel wide and as connected as it is: pixels go from the border inwards unless
/// something would fall apart or get a hole, or a line would get shorter.
/// Source: Pudney 1998, "Distance-ordered homotopic thinning".
/// @param distances of the mask
Mask thinned(const Mask& mask, const PixelGrid<int>& distances);

}  // namespace croquis::tracing
