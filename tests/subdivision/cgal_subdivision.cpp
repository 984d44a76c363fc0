// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/cgal_subdivision.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

namespace croquis::test {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

SurfaceMesh converted(const PolyMesh& mesh) {
  SurfaceMesh result;
  std::vector<SurfaceMesh::Vertex_index> vertices;
  for (const Vec3& p : mesh.positions) vertices.push_back(result.add_vertex(Point(p.x(), p.y(), p.z())));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<SurfaceMesh::Vertex_index> corners;
    for (const Index v : mesh.face(f)) corners.push_back(vertices[v]);
    result.add_face(corners);
  }
  return result;
}

std::vector<Vec3> points_of(const SurfaceMesh& mesh) {
  std::vector<Vec3> points;
  for (const auto vertex : mesh.vertices()) {
    const Point& p = mesh.point(vertex);
    points.emplace_back(p.x(), p.y(), p.z());
  }
  return points;
}

}  // namespace

std::vector<Vec3> cgal_catmull_clark(const PolyMesh& mesh, int level) {
  SurfaceMesh converted_mesh = converted(mesh);
  CGAL::Subdivision_method_3::CatmullClark_subdivision(
      converted_mesh, CGAL::parameters::number_of_iterations(static_cast<unsigned>(level)));
  return points_of(converted_mesh);
}

std::vector<Vec3> cgal_loop(const PolyMesh& mesh, int level) {
  SurfaceMesh converted_mesh = converted(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(converted_mesh,
                                               CGAL::parameters::number_of_iterations(static_cast<unsigned>(level)));
  return points_of(converted_mesh);
}

CgalLevel cgal_doo_sabin(const PolyMesh& mesh, int level) {
  SurfaceMesh converted_mesh = converted(mesh);
  CGAL::Subdivision_method_3::DooSabin_subdivision(
      converted_mesh, CGAL::parameters::number_of_iterations(static_cast<unsigned>(level)));
  converted_mesh.collect_garbage();
  return {points_of(converted_mesh), converted_mesh.number_of_edges(), converted_mesh.number_of_faces()};
}

}  // namespace croquis::test
