// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <Eigen/Geometry>

#include "croquis/geometry/poly_mesh.h"

/// Of faces of a mesh of triangles.
namespace croquis::test {

inline Vec3 centre_of_triangle(const PolyMesh& mesh, std::size_t face) {
  const auto t = mesh.face(face);
  return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
}

/// Twice its area long.
inline Vec3 area_vector_of_triangle(const PolyMesh& mesh, std::size_t face) {
  const auto t = mesh.face(face);
  const Vec3& a = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
}

inline Vec3 normal_of_triangle(const PolyMesh& mesh, std::size_t face) {
  return area_vector_of_triangle(mesh, face).normalized();
}

inline double area_of_triangle(const PolyMesh& mesh, std::size_t face) {
  return area_vector_of_triangle(mesh, face).norm() / 2;
}

}  // namespace croquis::test
