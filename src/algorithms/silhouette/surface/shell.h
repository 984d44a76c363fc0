// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "algorithms/silhouette/skeleton/attachments.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::silhouette {

/// A closed surface of triangles: of one object of a figure, or of several joined.
struct Shell {
  PolyMesh mesh;                             ///< outward
  std::vector<Index> objects;                ///< in the order in which they were joined
  std::vector<Index> face_objects = {};      ///< per face; empty: all are the only object's
  int euler = 0;                             ///< counted
  std::map<ObjectPair, double> blends = {};  ///< radii of its rounded seams, in parts of what was asked for

  Index object_of(Index face) const { return face_objects.empty() ? objects.front() : face_objects[face]; }
};

/// Twice the area of a triangle as the viewer sees it, negative where it faces away.
inline double seen_area(const PolyMesh& mesh, Index triangle) {
  const auto corners = mesh.face(triangle);
  const Vec2 a = mesh.positions[corners[0]].head<2>();
  return cross(mesh.positions[corners[1]].head<2>() - a, mesh.positions[corners[2]].head<2>() - a);
}

/// The Euler number of a closed surface of triangles, which has three edges for every two faces.
inline int closed_euler_number(const PolyMesh& mesh) {
  return static_cast<int>(mesh.vertex_count()) - static_cast<int>(mesh.face_count() / 2);
}

/// Adds the vertices and triangles of a part; channels are the caller's.
inline void append_triangles(const PolyMesh& part, PolyMesh& mesh) {
  const auto first = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  for (std::size_t f = 0; f < part.face_count(); ++f) {
    const auto face = part.face(f);
    mesh.add_triangle(face[0] + first, face[1] + first, face[2] + first);
  }
}

}  // namespace croquis::silhouette
