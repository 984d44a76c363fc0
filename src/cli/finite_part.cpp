// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/finite_part.h"

#include <string>
#include <utility>
#include <vector>

#include "croquis/base/limits.h"
#include "croquis/geometry/mesh_part.h"

namespace croquis::cli {
namespace {

Finding dropped_finding(const PolyMesh& before, const PolyMesh& after) {
  const std::size_t vertices = before.vertex_count() - after.vertex_count();
  const std::size_t faces = before.face_count() - after.face_count();
  return make_warning(Category::Malformed, "W_BAD_DROPPED",
                      "Dropped " + std::to_string(vertices) + (vertices == 1 ? " vertex" : " vertices") +
                          " with coordinates that aren't finite or are larger than 1e30, and " + std::to_string(faces) +
                          (faces == 1 ? " face that uses it" : " faces that use them") +
                          "; those behind them have lower numbers now.");
}

}  // namespace

FinitePart finite_part(PolyMesh mesh) {
  std::vector<bool> is_finite(mesh.vertex_count());
  bool all_finite = true;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    is_finite[v] = are_usable_numbers(mesh.positions[v]);
    all_finite = all_finite && is_finite[v];
  }
  if (all_finite) return {std::move(mesh), {}};
  MeshPart part = part_of(mesh, is_finite, std::vector<bool>(mesh.face_count(), true));
  Findings warnings = {dropped_finding(mesh, part.mesh)};
  return {std::move(part.mesh), std::move(warnings)};
}

}  // namespace croquis::cli
