// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_checks.h"

#include <algorithm>

namespace croquis {
namespace {

constexpr std::size_t named_faces = 100;

// Sorting keeps faces with very many corners from costing their square.
bool repeats_a_vertex(std::span<const Index> face, std::vector<Index>& scratch) {
  if (face.size() == 3) return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
  scratch.assign(face.begin(), face.end());
  std::sort(scratch.begin(), scratch.end());
  return std::adjacent_find(scratch.begin(), scratch.end()) != scratch.end();
}

void warn_of_degenerate_faces(const PolyMesh& mesh, ReadContext& context) {
  std::vector<Index> scratch;
  std::vector<Subject> subjects;
  std::size_t count = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (!repeats_a_vertex(mesh.face(f), scratch)) continue;
    if (++count <= named_faces) subjects.push_back(face_subject(f).front());
  }
  if (count == 0) return;
  const std::string first = name_of(subjects.front());
  const std::string message = count == 1 ? "face " + first + " uses a vertex twice; it is kept as it is"
                                         : std::to_string(count) + " faces use a vertex twice, the first is face " +
                                               first + "; they are kept as they are";
  context.warn("W_DEGENERATE", message, {}, std::move(subjects));
}

bool all_points_equal(const PolyMesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [&](const Vec3& p) { return p == mesh.positions.front(); });
}

}  // namespace

void check_mesh(const PolyMesh& mesh, bool require_faces, ReadContext& context) {
  if (require_faces && mesh.face_count() == 0) {
    context.fail("E_NO_FACES",
                 "the file has " + std::to_string(mesh.vertex_count()) + " vertices and " +
                     std::to_string(mesh.line_count()) + " polylines, but no faces",
                 {});
  }
  if (mesh.vertex_count() == 0) context.fail("E_EMPTY", "the file has no vertices", {});
  if (mesh.face_count() > 0 && all_points_equal(mesh)) {
    context.fail("E_DEGENERATE", "all points of the model are the same", {});
  }
  warn_of_degenerate_faces(mesh, context);
}

}  // namespace croquis
