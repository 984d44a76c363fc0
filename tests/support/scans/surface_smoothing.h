// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/poly_mesh.h"
#include "croquis/implicit/surface_improvement.h"

namespace croquis::test {

/// Evens the triangles of a surface: every vertex moves to the mean of the centroids of its triangles, weighted by
/// their areas (Yoo 2005, eq. 9), all at the same time, and back onto the surface; so many rounds. Boundaries stay.
/// @return the last projection's report
implicit::ProjectionReport smooth_on_surface(PolyMesh& mesh, const implicit::Field& field, int rounds,
                                             const implicit::ProjectionOptions& options);

}  // namespace croquis::test
