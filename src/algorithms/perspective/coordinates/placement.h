// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/perspective/coordinates/contradiction_search.h"

namespace croquis {

/// From coordinates relative to the eye, each component with a scale of its own, to the world.
struct Placement {
  std::vector<double> scale;  ///< model units, of each component
  Vec3 eye = Vec3::Zero();    ///< model units
  Findings warnings;          ///< LENGTH_UNUSED
};

Placement placement(const PerspectiveDrawing& drawing, const DrawingVertices& vertices, const CameraEstimate& camera,
                    const SolvedVertices& solved, Index largest_component);

}  // namespace croquis
