// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include "bench/cpu_time.h"
#include "bench/scans/hole_peers.h"

namespace croquis::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
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

/// Which vertex of the mesh given a copy is of.
class Originals : public pmp::Default_orientation_visitor {
 public:
  explicit Originals(std::size_t vertices) {
    for (std::size_t v = 0; v < vertices; ++v) numbers_->push_back(static_cast<Index>(v));
  }

  void duplicated_vertex(std::size_t vertex, std::size_t copy) {
    numbers_->resize(std::max(numbers_->size(), copy + 1), no_index);
    (*numbers_)[copy] = (*numbers_)[vertex];
  }

  const std::vector<Index>& numbers() const { return *numbers_; }

 private:
  std::shared_ptr<std::vector<Index>> numbers_ = std::make_shared<std::vector<Index>>();  // CGAL may copy visitors
};

/// Turned and cut apart until it is manifold. The vertices given keep their numbers.
Surface manifold_surface(const PolyMesh& mesh, Originals& originals) {
  std::vector<Kernel::Point_3> points;
  for (const Vec3& p : mesh.positions) points.emplace_back(p.x(), p.y(), p.z());
  std::vector<std::vector<std::size_t>> faces;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  pmp::orient_polygon_soup(points, faces, CGAL::parameters::visitor(originals));
  Surface surface;
  pmp::polygon_soup_to_polygon_mesh(points, faces, surface);
  return surface;
}

}  // namespace

FilledRims cgal_fill_rims(const PolyMesh& mesh, unsigned continuity) {
  Originals originals(mesh.vertex_count());
  Surface surface = manifold_surface(mesh, originals);
  const std::size_t given_vertices = surface.number_of_vertices();
  const auto number = [&](Surface::Vertex_index v) {
    const auto i = static_cast<std::size_t>(v);
    return i < given_vertices ? originals.numbers()[i] : static_cast<Index>(mesh.vertex_count() + i - given_vertices);
  };
  FilledRims result;
  FilledMesh& filled = result.filled;
  filled.mesh = mesh;
  filled.first_new_face = mesh.face_count();
  std::vector<Surface::Halfedge_index> rims;
  pmp::extract_boundary_cycles(surface, std::back_inserter(rims));
  for (const auto rim : rims) {
    FilledRim& made = result.rims.emplace_back();
    for (const auto v : CGAL::vertices_around_face(rim, surface)) made.vertices.push_back(number(v));
    std::vector<Surface::Face_index> faces;
    std::vector<Surface::Vertex_index> vertices;
    made.cpu_ms = cpu_ms([&] {
      pmp::triangulate_refine_and_fair_hole(
          surface, rim, std::back_inserter(faces), std::back_inserter(vertices),
          CGAL::parameters::fairing_continuity(continuity).do_not_use_cubic_algorithm(true));
    });
    filled.cpu_ms += made.cpu_ms;
    made.first_face = filled.mesh.face_count();
    made.face_count = faces.size();
    for (const auto f : faces) {
      std::vector<Index> corners;
      for (const auto v : surface.vertices_around_face(surface.halfedge(f))) corners.push_back(number(v));
      filled.mesh.add_face(corners);
    }
  }
  for (std::size_t v = given_vertices; v < surface.number_of_vertices(); ++v) {
    const auto& p = surface.point(Surface::Vertex_index(static_cast<Index>(v)));
    filled.mesh.positions.emplace_back(p.x(), p.y(), p.z());
  }
  return result;
}

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
