// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis {

struct TessellationOptions {
  double chord_tolerance = 0.0005;  ///< greatest distance of mesh and surface, × diagonal of the box; 0.00001..0.01
  std::size_t most_spans = 128;     ///< of an edge or across a patch
};

/// The corner channel of unit normals (3 doubles) is "normal"; the face channel "group" ("f0", "f1" …) has for each
/// triangle the outline that its face of the B-rep fills.
struct Tessellation {
  PolyMesh mesh;               ///< triangles, counter-clockwise from outside
  std::vector<double> volume;  ///< per shell; of open shells what the cone from the origin has
  Findings warnings;           ///< PATCH_FOLDED: planar faces whose outlines cross, made as fans
};

/// Triangles along the surfaces of a B-rep. Each edge is sampled once and both faces use these points, so that the mesh
/// of a closed shell is watertight; vertices are shared by number, never by distance. Corners at smooth edges share
/// normals. Planar faces are triangulated by constrained Delaunay, holes included; patches by grids that are stitched
/// to the samples of their edges.
/// @throws Cancelled
Tessellation tessellate(const Brep& brep, Progress& progress, const TessellationOptions& options = {});

}  // namespace croquis
