// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "algorithms/mesh_editing/lifted_region.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis {
namespace {

// A vertex between two edges that nearly go back on each other moves at most this many widths.
constexpr double farthest_corner = 4;
// Less of an edge is nothing: faces without area would be left.
constexpr double least_share = 1e-6;

/// Where the rim's vertices go for a width of 1.
std::vector<Vec3> inward_moves(const PolyMesh& mesh, const MeshTopology& topology, const LiftedRegion& region,
                               const LiftedMesh& lifted) {
  std::vector<std::vector<Vec3>> sides(lifted.edit.mesh.vertex_count());
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    if (!region.lifts(topology.face(corner)) || !region.on_rim(corner)) continue;
    const Index next = topology.next(corner);
    const Vec3 along = mesh.positions[topology.vertex(next)] - mesh.positions[topology.vertex(corner)];
    const Vec3 inward = area_normal(mesh, topology.face(corner)).cross(along).normalized();
    if (!inward.allFinite()) continue;  // an edge or a face without size has no inside
    sides[lifted.vertices.vertex[corner]].push_back(inward);
    sides[lifted.vertices.vertex[next]].push_back(inward);
  }
  std::vector<Vec3> moves(sides.size(), Vec3::Zero());
  for (std::size_t vertex = 0; vertex < sides.size(); ++vertex) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& side : sides[vertex]) sum += side;
    if (!(sum.norm() > 0)) continue;
    // Each edge is to be left by the width, so corners go farther than edges.
    const double share = sum.norm() / static_cast<double>(sides[vertex].size());
    moves[vertex] = sum.normalized() / std::max(share, 1 / farthest_corner);
  }
  return moves;
}

void move_by(PolyMesh& mesh, const std::vector<Vec3>& moves, double width) {
  for (std::size_t vertex = 0; vertex < moves.size(); ++vertex) mesh.positions[vertex] += width * moves[vertex];
}

/// Whether an edge of a face runs back, or the face looks the other way. A square that is inset by more than half its
/// side looks the same way as before: only its edges show it.
bool is_inside_out(const PolyMesh& before, const PolyMesh& after, Index face) {
  const auto corners = before.face(face);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Index from = corners[i], to = corners[(i + 1) % corners.size()];
    const Vec3 side = before.positions[to] - before.positions[from];
    const double kept = side.dot(after.positions[to] - after.positions[from]);
    if (side.squaredNorm() > 0 && !(kept > least_share * side.squaredNorm())) return true;
  }
  const Vec3 normal = area_normal(before, face);
  return normal.squaredNorm() > 0 && !(area_normal(after, face).dot(normal) > 0);
}

/// The first lifted face without room for the width, or no_index.
Index without_room(const LiftedMesh& lifted, const std::vector<Vec3>& moves, double width) {
  PolyMesh moved = lifted.edit.mesh;
  move_by(moved, moves, width);
  for (const Index face : lifted.edit.moved_faces) {
    if (is_inside_out(lifted.edit.mesh, moved, face)) return face;
  }
  return no_index;
}

/// The greatest width for which every face has room.
double room_for(const LiftedMesh& lifted, const std::vector<Vec3>& moves, double too_wide) {
  double low = 0, high = too_wide;
  for (int round = 0; round < 30; ++round) {
    const double middle = (low + high) / 2;
    (without_room(lifted, moves, middle) == no_index ? low : high) = middle;
  }
  return low;
}

}  // namespace

MeshEdit inset_faces(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> faces, double width) {
  LiftedRegion region(topology, faces);
  if (region.empty()) throw Error(make_error(Category::Usage, "E_INPUT", "There is no face to inset: select some"));
  LiftedMesh result = lift_region(mesh, topology, region);
  const std::vector<Vec3> moves = inward_moves(mesh, topology, region, result);
  if (const Index face = without_room(result, moves, width); face != no_index) {
    const std::string name = std::to_string(face);
    throw Error(make_error(Category::Usage, "E_INPUT",
                           "Face " + name + " has no room for an inset of " + number_text(width, 3) +
                               ": take less than " + number_text(room_for(result, moves, width), 3),
                           {numbered_subject(SubjectKind::Face, face)}));
  }
  move_by(result.edit.mesh, moves, width);
  return std::move(result.edit);
}

}  // namespace croquis
