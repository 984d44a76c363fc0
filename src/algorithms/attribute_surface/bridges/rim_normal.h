// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Unit normal of the surface that a mesh stands for at one of its vertices: the normals of the faces within two rings,
/// as a linear function of the place, weighted by area. Their mean alone would be that of a place inside where the
/// vertex lies on a boundary. Faces that turn away by more than 60 degrees from those at the vertex are left out. Zero
/// where no face has an area.
Vec3 rim_normal(const PolyMesh& mesh, const MeshTopology& topology, Index vertex);

}  // namespace croquis
