// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::silhouette {

/// Appends a skeleton: its nodes with the vertex channel "radius", one polyline per branch between ends and junctions.
/// A loop returns to its first vertex. Nodes without edges stay vertices.
void append_skeleton(const Skeleton& skeleton, PolyMesh& curves);

}  // namespace croquis::silhouette
