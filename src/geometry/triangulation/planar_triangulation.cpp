// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/planar_triangulation.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "geometry/exact_kernel.h"

namespace croquis {
namespace {

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, ExactKernel>;
using PlainFaceBase = CGAL::Constrained_triangulation_face_base_2<ExactKernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<Index, ExactKernel, PlainFaceBase>;
using DataStructure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<ExactKernel, DataStructure, CGAL::No_constraint_intersection_tag>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;

std::vector<VertexHandle> insert_points(std::span<const Vec2> points, Triangulation& triangulation,
                                        PlanarConflict& conflict) {
  std::vector<std::pair<ExactKernel::Point_2, Index>> numbered;
  numbered.reserve(points.size());
  for (const Vec2& point : points) {
    numbered.emplace_back(ExactKernel::Point_2(point.x(), point.y()), static_cast<Index>(numbered.size()));
  }
  triangulation.insert(numbered.begin(), numbered.end());

  std::vector<VertexHandle> handles(points.size());
  for (const VertexHandle vertex : triangulation.finite_vertex_handles()) handles[vertex->info()] = vertex;
  if (triangulation.number_of_vertices() == points.size()) return handles;
  for (Index i = 0; i < points.size(); ++i) {
    if (handles[i] != VertexHandle()) continue;
    // Inserting a point again finds the vertex that has its place.
    const VertexHandle twin = triangulation.insert(numbered[i].first);
    conflict.coincident_points.emplace_back(std::min(i, twin->info()), std::max(i, twin->info()));
  }
  return handles;
}

void insert_constraints(std::span<const std::array<Index, 2>> constraints, std::span<const VertexHandle> handles,
                        Triangulation& triangulation, PlanarConflict& conflict) {
  for (Index c = 0; c < constraints.size(); ++c) {
    if (constraints[c][0] == constraints[c][1]) {  // CGAL would walk from the point without end
      conflict.blocked_constraints.push_back(c);
      continue;
    }
    try {
      triangulation.insert_constraint(handles[constraints[c][0]], handles[constraints[c][1]]);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      conflict.blocked_constraints.push_back(c);
    }
  }
}

PlanarTriangulation flatten(Triangulation& triangulation) {
  PlanarTriangulation flat;
  const std::size_t count = triangulation.number_of_faces();
  flat.triangles.reserve(count);
  flat.neighbours.reserve(count);
  flat.constraints.assign(count, {no_index, no_index, no_index});
  for (const FaceHandle face : triangulation.all_face_handles()) face->info() = no_index;
  for (const FaceHandle face : triangulation.finite_face_handles()) {
    face->info() = static_cast<Index>(flat.triangles.size());
    flat.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  for (const FaceHandle face : triangulation.finite_face_handles()) {
    flat.neighbours.push_back({face->neighbor(0)->info(), face->neighbor(1)->info(), face->neighbor(2)->info()});
  }
  return flat;
}

/// A constraint that ran through another point was cut there by the triangulation and is no edge: a conflict.
void mark_constraints(std::span<const std::array<Index, 2>> constraints, std::span<const VertexHandle> handles,
                      const Triangulation& triangulation, PlanarTriangulationResult& result) {
  for (Index c = 0; c < constraints.size(); ++c) {
    FaceHandle face;
    int corner = 0;
    if (!triangulation.is_edge(handles[constraints[c][0]], handles[constraints[c][1]], face, corner)) {
      result.conflict.blocked_constraints.push_back(c);
      continue;
    }
    const FaceHandle twin = face->neighbor(corner);
    const int twin_corner = twin->index(face);
    if (face->info() != no_index) {
      result.triangulation.constraints[face->info()][static_cast<std::size_t>(corner)] = c;
    }
    if (twin->info() != no_index) {
      result.triangulation.constraints[twin->info()][static_cast<std::size_t>(twin_corner)] = c;
    }
  }
}

/// Of a triangle that the walk from the hull hasn't come to.
constexpr std::uint8_t unknown_side = 2;

/// Begins at the hull, outside of all loops.
std::vector<std::uint8_t> sides_of_loops(const PlanarTriangulation& plane) {
  std::vector<std::uint8_t> inside(plane.triangles.size(), unknown_side);
  std::vector<Index> pending;
  for (Index t = 0; t < plane.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3 && inside[t] == unknown_side; ++i) {
      if (plane.neighbours[t][i] != no_index) continue;
      inside[t] = plane.constraints[t][i] != no_index ? 1 : 0;
      pending.push_back(t);
    }
  }
  while (!pending.empty()) {
    const Index t = pending.back();
    pending.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Index other = plane.neighbours[t][i];
      if (other == no_index || inside[other] != unknown_side) continue;
      const bool crosses = plane.constraints[t][i] != no_index;
      inside[other] = static_cast<std::uint8_t>(crosses != (inside[t] != 0));
      pending.push_back(other);
    }
  }
  return inside;
}

}  // namespace

PlanarTriangulationResult triangulate(std::span<const Vec2> points, std::span<const std::array<Index, 2>> constraints) {
  PlanarTriangulationResult result;
  Triangulation triangulation;
  const std::vector<VertexHandle> handles = insert_points(points, triangulation, result.conflict);
  if (!result.conflict.empty()) return result;
  insert_constraints(constraints, handles, triangulation, result.conflict);
  if (!result.conflict.empty() || triangulation.dimension() < 2) return result;
  result.triangulation = flatten(triangulation);
  mark_constraints(constraints, handles, triangulation, result);
  if (!result.conflict.empty()) result.triangulation = {};
  return result;
}

std::vector<std::array<Index, 3>> triangles_inside(const PlanarTriangulation& plane) {
  const std::vector<std::uint8_t> inside = sides_of_loops(plane);
  std::vector<std::array<Index, 3>> triangles;
  for (std::size_t t = 0; t < inside.size(); ++t) {
    if (inside[t] == 1) triangles.push_back(plane.triangles[t]);
  }
  return triangles;
}

}  // namespace croquis
