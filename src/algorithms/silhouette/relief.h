// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/options.h"
#include "croquis/silhouette/solid.h"

namespace croquis::silhouette {

/// Makes the lines of a solid grooves or ridges, with finer triangles there. What faces the viewer moves along the
/// view, so that the outline stays as drawn: less towards it, and by a quarter of the way to the next surface at most.
/// Where the surface would meet itself, all get half the depth, up to three times. Lines that become none stay and are
/// named.
/// @param options of which the shape isn't Line
/// @param unit    diagonal of the sketch / 1000
/// @param solid   its mesh has channels of faces alone
/// @throws Cancelled
void carve_lines(const Drawing& drawing, const DetailOptions& options, double unit, Solid& solid, Progress& progress);

}  // namespace croquis::silhouette
