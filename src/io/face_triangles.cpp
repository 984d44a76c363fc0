// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/face_triangles.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "croquis/geometry/planar_triangulation.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;  // of corners 0..k-1 of one face

// The face seen along its normal, counter-clockwise; empty when it has no normal.
std::vector<Vec2> projected(const PolyMesh& mesh, std::span<const Index> face) {
  const Vec3 normal = area_normal(mesh.positions, face).normalized();
  if (!normal.allFinite() || normal.isZero()) return {};
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vec2> points;
  for (const Index vertex : face) {
    const Vec3 offset = mesh.positions[vertex] - mesh.positions[face[0]];
    points.emplace_back(offset.dot(u), offset.dot(v));
  }
  return points;
}

bool is_convex(const std::vector<Vec2>& points) {
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2& at = points[(i + 1) % count];
    if (cross(at - points[i], points[(i + 2) % count] - at) < 0) return false;
  }
  return true;
}

Triangles fan(std::size_t corners) {
  Triangles triangles;
  for (Index i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

Triangles triangles_of(const PolyMesh& mesh, std::span<const Index> face) {
  if (face.size() == 3) return fan(3);
  const std::vector<Vec2> points = projected(mesh, face);
  if (points.empty() || is_convex(points)) return fan(face.size());
  std::vector<std::array<Index, 2>> ring;
  const auto count = static_cast<Index>(face.size());
  for (Index i = 0; i < count; ++i) ring.push_back({i, (i + 1) % count});
  const PlanarTriangulationResult result = triangulate(points, ring);
  if (!result.conflict.empty()) return fan(face.size());
  Triangles triangles = triangles_inside(result.triangulation);
  return triangles.size() + 2 == face.size() ? triangles : fan(face.size());
}

}  // namespace

FaceTriangles face_triangles(const PolyMesh& mesh) {
  FaceTriangles result;
  result.triangles.reserve(mesh.corners.size());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() < 3) continue;
    result.cut_polygons |= face.size() > 3;
    for (const auto& corners : triangles_of(mesh, face)) {
      result.triangles.push_back({face[corners[0]], face[corners[1]], face[corners[2]]});
      result.faces.push_back(static_cast<Index>(f));
    }
  }
  return result;
}

}  // namespace croquis
