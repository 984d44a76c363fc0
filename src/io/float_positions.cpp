// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/float_positions.h"

#include <algorithm>

#include "croquis/base/error.h"

namespace croquis {

// One by one: Eigen 3.4 leaves doubles unrounded in cast<float>().cast<double>() where it works on packets.
Vec3 as_floats(const Vec3& point) {
  Vec3 rounded;
  for (int k = 0; k < 3; ++k) rounded[k] = static_cast<double>(static_cast<float>(point[k]));
  return rounded;
}

bool positions_are_floats(const PolyMesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3& p) { return as_floats(p) == p; });
}

std::vector<Vec3> positions_as_floats(const PolyMesh& mesh, MeshFormat format) {
  std::vector<Vec3> positions = mesh.positions;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    positions[v] = as_floats(positions[v]);
    if (positions[v].allFinite()) continue;
    throw Error(make_error(Category::Geometry, "E_OUT_OF_RANGE",
                           "Vertex " + std::to_string(v) + " is too far out for the 32-bit numbers of " +
                               to_string(format) + "; scale the model down or write another format.",
                           {numbered_subject(SubjectKind::Vertex, v)}));
  }
  return positions;
}

}  // namespace croquis
