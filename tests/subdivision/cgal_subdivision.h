// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/poly_mesh.h"

/// CGAL's subdivision of closed meshes: an independent oracle. In a file of its own for CGAL's compile time.
namespace croquis::test {

/// The points of that level in CGAL's order.
std::vector<Vec3> cgal_catmull_clark(const PolyMesh& mesh, int level);
std::vector<Vec3> cgal_loop(const PolyMesh& mesh, int level);

}  // namespace croquis::test
