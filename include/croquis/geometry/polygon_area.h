// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Geometry>

#include "croquis/geometry/poly_mesh.h"

/// Normals of polygons, as long as their areas (Newell's sum, from the first corner for precision far from the origin).
/// Of a polygon that is not flat: along the direction in which it covers most, as long as what it covers there. Zero
/// for fewer than three corners.
namespace croquis {

/// @param corner corner(i) is the place of corner i, for i below `count`
template <typename Corner>
Vec3 area_normal(std::size_t count, const Corner& corner) {
  Vec3 sum = Vec3::Zero();
  if (count < 3) return sum;
  const Vec3 origin = corner(std::size_t{0});
  for (std::size_t i = 1; i + 1 < count; ++i) sum += (corner(i) - origin).cross(corner(i + 1) - origin);
  return sum / 2;
}

/// @param polygon its corners, around it
inline Vec3 area_normal(std::span<const Vec3> polygon) {
  return area_normal(polygon.size(), [&](std::size_t i) -> const Vec3& { return polygon[i]; });
}

/// @param corners indices into positions, around the polygon
inline Vec3 area_normal(std::span<const Vec3> positions, std::span<const Index> corners) {
  return area_normal(corners.size(), [&](std::size_t i) -> const Vec3& { return positions[corners[i]]; });
}

inline Vec3 area_normal(const PolyMesh& mesh, std::size_t face) { return area_normal(mesh.positions, mesh.face(face)); }

}  // namespace croquis
