// SPDX-License-Identifier: GPL-3.0-or-later
// The only code that calls CGAL to fill holes.
#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <utility>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/fair.h>
#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "algorithms/hole_filling/fairing/fairing.h"
#include "croquis/base/error.h"

namespace croquis::hole_filling {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Delaunay = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>,
                                                 CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;
namespace pmp = CGAL::Polygon_mesh_processing;

Point to_point(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// @return false when the surroundings aren't manifold, the system is singular or a coordinate isn't finite
bool refined_and_faired(LoosePatch& patch, double density, const Progress& progress) {
  Mesh mesh;
  std::vector<Mesh::Face_index> faces;  // of the patch
  for (const Vec3& point : patch.points) mesh.add_vertex(to_point(point));
  for (const Triangles* triangles : {&patch.surroundings, &patch.triangles}) {
    faces.clear();
    for (const auto& [a, b, c] : *triangles) {
      faces.push_back(mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c)));
      if (faces.back() == Mesh::null_face()) return false;
    }
  }
  progress.check();
  std::vector<Mesh::Vertex_index> new_vertices;
  std::vector<Mesh::Face_index> new_faces;
  pmp::refine(mesh, faces, std::back_inserter(new_faces), std::back_inserter(new_vertices),
              CGAL::parameters::density_control_factor(density));
  faces.insert(faces.end(), new_faces.begin(), new_faces.end());
  progress.check();
  if (!new_vertices.empty() && !pmp::fair(mesh, new_vertices, CGAL::parameters::fairing_continuity(1U))) return false;
  std::vector<Vec3> new_points;
  for (std::size_t v = patch.points.size(); v < mesh.number_of_vertices(); ++v) {
    const Point& point = mesh.point(Mesh::Vertex_index(static_cast<Index>(v)));
    new_points.emplace_back(point.x(), point.y(), point.z());
    if (!new_points.back().allFinite()) return false;
  }
  patch.points.insert(patch.points.end(), new_points.begin(), new_points.end());
  patch.triangles.clear();
  for (const Mesh::Face_index face : faces) {
    std::size_t i = 0;
    Triangle& t = patch.triangles.emplace_back();
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face))) t[i++] = vertex.idx();
  }
  return true;
}

}  // namespace

Triangles cgal_delaunay_triangles(std::span<const Vec3> points) {
  std::vector<std::pair<Point, Index>> numbered;
  for (const Vec3& point : points) numbered.emplace_back(to_point(point), static_cast<Index>(numbered.size()));
  const Delaunay tetrahedra(numbered.begin(), numbered.end());
  Triangles triangles;
  if (tetrahedra.dimension() < 2) return triangles;
  for (const auto& [cell, opposite] : tetrahedra.finite_facets()) {
    Triangle t{};
    std::size_t corners = 0;
    for (int i = 0; i < 4; ++i) {
      if (i != opposite) t[corners++] = cell->vertex(i)->info();
    }
    std::sort(t.begin(), t.end());
    triangles.push_back(t);
  }
  return triangles;
}

bool cgal_refine_and_fair(LoosePatch& patch, double density, const Progress& progress) {
  try {
    return refined_and_faired(patch, density, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace croquis::hole_filling
