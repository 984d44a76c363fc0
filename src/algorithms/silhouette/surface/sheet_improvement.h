// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/surface/sheet_mesh.h"
#include "croquis/base/progress.h"

namespace croquis::silhouette {

/// Flips edges and collapses short ones where triangles of the front or the back are slender in space.
///
/// Triangles that are even in the plane aren't so where a surface is steep, and each sheet carries the points of all
/// others. The rim stays as it is, no edge joins two of its vertices, every triangle keeps its sense in the plane, and
/// no sheet moves by more than its clearance, so that those that were apart stay apart. O(M) in practice.
/// @throws Cancelled
void improve_triangles(SheetMesh& mesh, Progress& progress);

}  // namespace croquis::silhouette
