// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ply/ply_columns.h"

namespace croquis {

/// Triangulates a range view: PLY's element `range_grid`, one row for each place of the scanner's grid, line by line,
/// with a list of the one vertex seen there, or of none (Stanford 3D Scanning Repository).
/// Four neighbours give two triangles, cut along the shorter diagonal, three give one. Triangles with an edge longer
/// than 4 × the median of the grid's edges would cross a step in depth: they are left out and counted in a warning.
/// All faces are turned so that their areas together look along +z, where Stanford's scanners stand.
/// @param indices the grid's list of vertices  @param mesh has the vertices; the triangles are added
/// @throws Error E_COUNT, E_INDEX
void triangulate_range_grid(const PlyGrid& size, const PlyTable& grid, const PlyColumn& indices, PolyMesh& mesh,
                            ReadContext& context);

}  // namespace croquis
