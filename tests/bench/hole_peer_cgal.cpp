// SPDX-License-Identifier: GPL-3.0-or-later
#include <iterator>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include "bench/cpu_time.h"
#include "bench/hole_peers.h"

namespace croquis::bench {
namespace {

using Surface = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

Surface to_cgal(const PolyMesh& mesh) {
  Surface surface;
  for (const Vec3& p : mesh.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  std::vector<Surface::Vertex_index> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    for (const Index v : mesh.face(f)) corners.emplace_back(v);
    surface.add_face(corners);
  }
  return surface;
}

PolyMesh from_cgal(const Surface& surface) {
  PolyMesh mesh;
  for (const auto v : surface.vertices()) {
    const auto& p = surface.point(v);
    mesh.positions.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : surface.faces()) {
    std::vector<Index> corners;
    for (const auto v : surface.vertices_around_face(surface.halfedge(f))) corners.push_back(static_cast<Index>(v));
    mesh.add_face(corners);
  }
  return mesh;
}

}  // namespace

FilledMesh cgal_fill(const PolyMesh& mesh, unsigned continuity) {
  Surface surface = to_cgal(mesh);
  FilledMesh filled;
  filled.first_new_face = surface.number_of_faces();
  filled.cpu_ms = cpu_ms([&] {
    std::vector<Surface::Halfedge_index> rims;
    pmp::extract_boundary_cycles(surface, std::back_inserter(rims));
    for (const auto rim : rims) {
      std::vector<Surface::Face_index> faces;
      std::vector<Surface::Vertex_index> vertices;
      pmp::triangulate_refine_and_fair_hole(surface, rim, std::back_inserter(faces), std::back_inserter(vertices),
                                            CGAL::parameters::fairing_continuity(continuity));
    }
  });
  filled.mesh = from_cgal(surface);
  return filled;
}

}  // namespace croquis::bench
