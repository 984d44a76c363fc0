// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/mesh_append.h"

#include <variant>
#include <vector>

namespace croquis::silhouette {

void append_triangles(const PolyMesh& part, PolyMesh& mesh) {
  const auto first = static_cast<Index>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  for (std::size_t f = 0; f < part.face_count(); ++f) {
    const auto face = part.face(f);
    mesh.add_triangle(face[0] + first, face[1] + first, face[2] + first);
  }
}

void append_curves(const PolyMesh& part, PolyMesh& curves) {
  const auto first = static_cast<Index>(curves.positions.size());
  if (curves.channel("radius", Domain::Vertex) == nullptr) {
    curves.channels.push_back({"radius", Domain::Vertex, 1, std::vector<double>{}, {}});
  }
  auto& radius = std::get<std::vector<double>>(curves.channel("radius", Domain::Vertex)->data);
  const auto& added = std::get<std::vector<double>>(part.channel("radius", Domain::Vertex)->data);
  radius.insert(radius.end(), added.begin(), added.end());
  curves.positions.insert(curves.positions.end(), part.positions.begin(), part.positions.end());
  for (std::size_t l = 0; l < part.line_count(); ++l) {
    std::vector<Index> line(part.line(l).begin(), part.line(l).end());
    for (Index& vertex : line) vertex += first;
    curves.add_line(line);
  }
}

}  // namespace croquis::silhouette
