// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/hole_filling/surface_reach.h"

namespace croquis::hole_filling {

/// The surface around a site's rims, by itself: what methods may be tried on.
struct KnownSurface {
  PolyMesh mesh;                 ///< triangles; vertices by their distance to the rims, those of the rims first
  std::vector<double> distance;  ///< per vertex, along edges to the rims
  double edge = 0;               ///< mean length of the rims' edges
  double size = 0;               ///< diameter of the largest rim
  double crease_cosine = 1;      ///< of the site, see there
};

/// Triangles all of whose vertices edges join to the rims within max(`reach` × size, `least_reach` × edge), and of
/// these the `most_vertices` nearest. n log n in what is reached.
KnownSurface known_surface(const HoleSite& site, double reach, double least_reach, std::size_t most_vertices);

/// The same of what has been reached already: vertex i is reached[i].
KnownSurface known_surface(const HoleSite& site, const std::vector<ReachedVertex>& reached);

}  // namespace croquis::hole_filling
