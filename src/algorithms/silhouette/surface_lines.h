// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/solid.h"

namespace croquis::silhouette {

/// Carries strokes onto the front of a solid, along the direction in which they were drawn. A line ends where there is
/// no surface, and where the surface in front is another one.
/// @param mesh    triangles
/// @param strokes of the drawing
/// @param step    distance of the points, sketch units
std::vector<SurfaceLine> surface_lines(const Drawing& drawing, const std::vector<Index>& strokes, const PolyMesh& mesh,
                                       double step);

}  // namespace croquis::silhouette
