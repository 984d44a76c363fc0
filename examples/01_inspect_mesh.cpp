// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh is a plain value: fill it, validate it, ask what it is.
#include <array>
#include <iostream>

#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/poly_mesh.h"

int main() {
  using namespace croquis;
  PolyMesh pyramid;
  pyramid.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1.5}};
  pyramid.add_face(std::array<Index, 4>{3, 2, 1, 0});
  for (Index side = 0; side < 4; ++side) pyramid.add_triangle(side, (side + 1) % 4, 4);

  Progress progress;
  const MeshReport report = inspect(pyramid, true, progress);
  std::cout << report.faces << " faces, " << report.edges << " edges, volume " << *report.volume << ", "
            << (report.closed ? "closed" : "open") << ", " << *report.self_intersections << " self-intersections\n";
  return validate(pyramid).empty() && report.closed ? 0 : 1;
}
