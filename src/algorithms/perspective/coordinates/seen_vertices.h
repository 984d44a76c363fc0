// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "algorithms/perspective/coordinates/contradiction_search.h"

namespace croquis {

/// The vertices of a drawing as its camera sees them, and what its strokes tie.
TiedVertices tied_vertices(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                           const CameraEstimate& camera, std::span<const StrokeGroup> groups);

}  // namespace croquis
