// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/mesh_editing/lifted_region.h"
#include "croquis/base/error.h"

namespace croquis {

MeshEdit extrude_faces(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> faces,
                       const Vec3& offset) {
  LiftedRegion region(topology, faces);
  if (region.empty()) throw Error(make_error(Category::Usage, "E_INPUT", "There is no face to extrude: select some"));
  LiftedMesh result = lift_region(mesh, topology, region);
  for (const Index vertex : result.vertices.moved) result.edit.mesh.positions[vertex] += offset;
  return std::move(result.edit);
}

}  // namespace croquis
