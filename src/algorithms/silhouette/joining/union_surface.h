// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "algorithms/silhouette/surface/shell.h"

/// Unions as CGAL's algorithms take them.
namespace croquis::silhouette {

using UnionKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using UnionSurface = CGAL::Surface_mesh<UnionKernel::Point_3>;
using FaceObjects = UnionSurface::Property_map<UnionSurface::Face_index, Index>;

/// Per face the object of its part; 0 until it is set.
inline FaceObjects face_objects(UnionSurface& surface) {
  return surface.add_property_map<UnionSurface::Face_index, Index>("f:object", 0).first;
}

/// Without faces where they can't be added in this order.
inline UnionSurface to_surface(const Shell& shell) {
  UnionSurface surface;
  for (const Vec3& p : shell.mesh.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  FaceObjects objects = face_objects(surface);
  for (Index f = 0; f < shell.mesh.face_count(); ++f) {
    const auto corners = shell.mesh.face(f);
    const auto vertex = [&](std::size_t k) { return UnionSurface::Vertex_index(corners[k]); };
    const UnionSurface::Face_index face = surface.add_face(vertex(0), vertex(1), vertex(2));
    if (face == UnionSurface::null_face()) return {};
    objects[face] = shell.object_of(f);
  }
  return surface;
}

/// Points and faces that CGAL has marked as removed go.
inline Shell from_surface(UnionSurface& surface, std::vector<Index> objects) {
  surface.collect_garbage();
  const FaceObjects face_object = face_objects(surface);
  Shell result;
  result.objects = std::move(objects);
  for (const auto v : surface.vertices()) {
    const auto& p = surface.point(v);
    result.mesh.positions.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto face : surface.faces()) {
    std::array<Index, 3> corners{};
    std::size_t i = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(face))) corners[i++] = v.idx();
    result.mesh.add_triangle(corners[0], corners[1], corners[2]);
    result.face_objects.push_back(face_object[face]);
  }
  result.euler = closed_euler_number(result.mesh);
  return result;
}

}  // namespace croquis::silhouette
