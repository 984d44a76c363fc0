// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Normal of a polygon, as long as its area (Newell's sum, from its first corner for precision far from the origin).
inline Vec3 area_normal(const PolyMesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  Vec3 sum = Vec3::Zero();
  if (corners.size() < 3) return sum;
  const Vec3& origin = mesh.positions[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (mesh.positions[corners[i]] - origin).cross(mesh.positions[corners[i + 1]] - origin);
  }
  return sum / 2;
}

}  // namespace croquis
