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

struct LocalMesh {
  Mesh mesh;
  std::vector<Mesh::Face_index> patch;
  bool is_manifold = true;
};

LocalMesh build(const FairingInput& input) {
  LocalMesh local;
  for (const Vec3& point : input.points) local.mesh.add_vertex(to_point(point));
  const auto add = [&](const Triangle& t) {
    const auto face = local.mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
    local.is_manifold &= face != Mesh::null_face();
    return face;
  };
  for (const Triangle& t : input.surroundings) add(t);
  for (const Triangle& t : input.patch) local.patch.push_back(add(t));
  return local;
}

/// @return nothing when a coordinate isn't finite
std::optional<FairingResult> read_back(const FairingInput& input, const LocalMesh& local) {
  FairingResult result;
  for (std::size_t v = input.points.size(); v < local.mesh.number_of_vertices(); ++v) {
    const Point& point = local.mesh.point(Mesh::Vertex_index(static_cast<Index>(v)));
    result.new_points.emplace_back(point.x(), point.y(), point.z());
    if (!result.new_points.back().allFinite()) return std::nullopt;
  }
  for (const Mesh::Face_index face : local.patch) {
    Triangle t{};
    std::size_t i = 0;
    for (const auto vertex : local.mesh.vertices_around_face(local.mesh.halfedge(face))) t[i++] = vertex.idx();
    result.patch.push_back(t);
  }
  return result;
}

std::optional<FairingResult> refine_and_fair(const FairingInput& input, const Progress& progress) {
  LocalMesh local = build(input);
  if (!local.is_manifold) return std::nullopt;
  progress.check();
  std::vector<Mesh::Vertex_index> new_vertices;
  std::vector<Mesh::Face_index> new_faces;
  pmp::refine(local.mesh, local.patch, std::back_inserter(new_faces), std::back_inserter(new_vertices),
              CGAL::parameters::density_control_factor(input.density));
  local.patch.insert(local.patch.end(), new_faces.begin(), new_faces.end());
  progress.check();
  if (!new_vertices.empty() && !pmp::fair(local.mesh, new_vertices, CGAL::parameters::fairing_continuity(1U)))
    return std::nullopt;
  return read_back(input, local);
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

std::optional<FairingResult> cgal_refine_and_fair(const FairingInput& input, Progress& progress) {
  try {
    return refine_and_fair(input, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace croquis::hole_filling
