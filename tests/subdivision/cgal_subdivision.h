// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

/// CGAL's subdivision of closed meshes: an independent oracle. In a file of its own for CGAL's compile time.
namespace croquis::test {

/// The points of that level in CGAL's order.
std::vector<Vec3> cgal_catmull_clark(const PolyMesh& mesh, int level);
std::vector<Vec3> cgal_loop(const PolyMesh& mesh, int level);

struct CgalLevel {
  std::vector<Vec3> points;
  std::size_t edges = 0, faces = 0;
};
CgalLevel cgal_doo_sabin(const PolyMesh& mesh, int level);

}  // namespace croquis::test
