// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include "bench/cpu_time.h"
#include "bench/subdivision_peers.h"

namespace croquis::bench {

double cgal_doo_sabin_ms(const PolyMesh& mesh, int levels) {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point> surface;
  for (const Vec3& p : mesh.positions) surface.add_vertex(Point(p.x(), p.y(), p.z()));
  std::vector<CGAL::Surface_mesh<Point>::Vertex_index> corners;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    for (const Index v : mesh.face(f)) corners.emplace_back(v);
    surface.add_face(corners);
  }
  return cpu_ms([&] {
    CGAL::Subdivision_method_3::DooSabin_subdivision(
        surface, CGAL::parameters::number_of_iterations(static_cast<unsigned>(levels)));
  });
}

}  // namespace croquis::bench
