// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/attribute_surface/tessellation/face_samples.h"
#include "croquis/base/progress.h"

namespace croquis {

struct RefinedPlaces {
  FacePlaces plane;
  double error = 0;  ///< model units: 0, or the largest chord error that was left because of a limit
};

struct RefinementOptions {
  double tolerance = 0;            ///< model units, > 0
  bool insert_attributes = true;   ///< points and inner curves are vertices
  std::size_t most_inner = 60000;  ///< places inside a face
};

/// A Delaunay triangulation of the domain with places added where the surface is farther than the tolerance from a
/// triangle: at 25 places of each triangle, none along the rim, which keeps to its curves already.
/// @throws Cancelled
RefinedPlaces refined_places(const FaceSurface& surface, const FaceRim& rim, Progress& progress,
                             const RefinementOptions& options);

}  // namespace croquis
