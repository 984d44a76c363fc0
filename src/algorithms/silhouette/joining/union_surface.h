// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "algorithms/silhouette/joining/surface_union.h"

/// Unions as CGAL's algorithms take them.
namespace croquis::silhouette {

using UnionKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using UnionSurface = CGAL::Surface_mesh<UnionKernel::Point_3>;
using FaceObjects = UnionSurface::Property_map<UnionSurface::Face_index, Index>;

/// Per face the object of its part; 0 until it is set.
inline FaceObjects face_objects(UnionSurface& surface) {
  return surface.add_property_map<UnionSurface::Face_index, Index>("f:object", 0).first;
}

/// Points and faces that CGAL has marked as removed go.
inline SurfaceUnion from_surface(UnionSurface& surface) {
  surface.collect_garbage();
  const FaceObjects objects = face_objects(surface);
  SurfaceUnion result;
  for (const auto v : surface.vertices()) {
    const auto& p = surface.point(v);
    result.mesh.positions.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto face : surface.faces()) {
    std::array<Index, 3> corners{};
    std::size_t i = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(face))) corners[i++] = v.idx();
    result.mesh.add_triangle(corners[0], corners[1], corners[2]);
    result.face_objects.push_back(objects[face]);
  }
  return result;
}

}  // namespace croquis::silhouette
