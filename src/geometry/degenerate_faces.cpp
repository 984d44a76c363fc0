// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/degenerate_faces.h"

#include <algorithm>
#include <span>

#include "geometry/clear_sign.h"
#include "geometry/exact_kernel.h"

namespace croquis {
namespace {

bool repeats_vertex(std::span<const Index> face, std::vector<Index>& scratch) {
  scratch.assign(face.begin(), face.end());
  std::sort(scratch.begin(), scratch.end());
  return std::adjacent_find(scratch.begin(), scratch.end()) != scratch.end();
}

bool on_one_line(const PolyMesh& mesh, std::span<const Index> face) {
  const Vec3& first = mesh.positions[face[0]];
  const auto elsewhere = std::find_if(face.begin(), face.end(), [&](Index v) { return mesh.positions[v] != first; });
  if (elsewhere == face.end()) return true;
  const ExactKernel::Point_3 a = exact_point(first);
  const ExactKernel::Point_3 b = exact_point(mesh.positions[*elsewhere]);
  return std::all_of(elsewhere + 1, face.end(),
                     [&](Index v) { return CGAL::collinear(a, b, exact_point(mesh.positions[v])); });
}

/// A triangle with three places clearly apart, as nearly all are.
bool clearly_fine(const PolyMesh& mesh, std::span<const Index> face) {
  if (face.size() != 3) return false;
  const Vec3& a = mesh.positions[face[0]];
  const Vec3& b = mesh.positions[face[1]];
  const Vec3& c = mesh.positions[face[2]];
  return clearly_has_area(a, b, c, longest_edge_squared(a, b, c));
}

}  // namespace

std::vector<Index> degenerate_faces(const PolyMesh& mesh) {
  std::vector<Index> degenerate;
  std::vector<Index> scratch;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (clearly_fine(mesh, face)) continue;
    if (face.size() < 3 || repeats_vertex(face, scratch) || on_one_line(mesh, face)) degenerate.push_back(f);
  }
  return degenerate;
}

}  // namespace croquis
