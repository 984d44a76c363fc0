// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/poly_mesh.h"

namespace croquis::silhouette {

/// Adds the vertices and triangles of a part; channels are the caller's.
void append_triangles(const PolyMesh& part, PolyMesh& mesh);

/// Adds the vertices with their "radius", and the polylines of a part.
void append_curves(const PolyMesh& part, PolyMesh& curves);

}  // namespace croquis::silhouette
