// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/io/picture_trace.h"
#include "io/tracing/pixel_grid.h"

namespace croquis::tracing {

/// What was drawn on the ground of a picture.
struct Ink {
  PixelGrid<float> darkness;  ///< 0..1 of the ground's own brightness; about 0 where nothing is drawn
  Mask mask;                  ///< where it is dark enough to belong to a line or a dot
};

/// Finds ink whose brightness differs from that of the ground around it, on the picture scaled down to
/// options.longest_side. What is wider than options.widest_line in every direction is ground.
Ink find_ink(const Picture& picture, const TraceOptions& options, Progress& progress);

}  // namespace croquis::tracing
