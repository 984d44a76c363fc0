// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/tracing/line_joining.h"
#include "io/tracing/pixel_grid.h"

namespace croquis::tracing {

/// Takes what is far wider than a line out of a mask, and gives the borders of the compact ones among it: filled
/// shapes, such as eyes. Wide bands and what reaches to the picture's border are no shapes.
/// @param distances  of the mask, as distances_to_outside gives them; kept up to date
/// @param half_width pixels, the usual one of a line
/// @return closed lines in the middle of the shapes' outermost pixels
std::vector<TracedLine> take_dots(Mask& mask, PixelGrid<int>& distances, double half_width);

}  // namespace croquis::tracing
