// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits/moved_vertices.h"

#include <numeric>
#include <utility>

#include "edits/edit_parameters.h"

namespace croquis {

MeshEdit with_same_elements(PolyMesh mesh) {
  MeshEdit edit;
  edit.mesh = std::move(mesh);
  edit.vertex_source = all_elements(edit.mesh.vertex_count());
  edit.face_source = all_elements(edit.mesh.face_count());
  return edit;
}

MeshEdit with_vertices_moved(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind,
                             std::span<const Index> elements, const Eigen::Affine3d& map) {
  return with_same_elements(transformed(mesh, converted(topology, kind, ComponentKind::Vertex, elements), map));
}

Vec3 pivot_of(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind, std::span<const Index> elements,
              const ParameterValues& parameters) {
  const Elements vertices = converted(topology, kind, ComponentKind::Vertex, elements);
  Vec3 sum = Vec3::Zero();
  for (const Index vertex : vertices) sum += mesh.positions[vertex];
  return vector_of(parameters, "about", sum / static_cast<double>(vertices.size()));
}

}  // namespace croquis
