// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "algorithms/mesh_editing/mesh_rebuild.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis {
namespace {

/// The faces to lift, and which of their vertices part from the rest.
class LiftedRegion {
 public:
  LiftedRegion(const MeshTopology& topology, std::span<const Index> faces);

  bool lifts(Index face) const { return lifted_[face] != 0; }
  bool empty() const;

  /// Whether a wall rises from the edge that this corner of a lifted face starts.
  bool on_rim(Index corner) const;

  /// The corners of a vertex that stay together share one number.
  Index umbrella(Index corner) { return umbrellas_.root(corner); }

  /// Whether the vertex stays below and a copy of it rises.
  bool parts(Index corner) { return parts_.contains(umbrella(corner)); }

 private:
  void join_corners();
  void join(Index a, Index b);
  void find_rims();

  const MeshTopology& topology_;
  std::vector<char> lifted_;
  DisjointSets umbrellas_;
  std::set<Index> parts_;
};

/// Old corners to the vertices that they have now.
struct LiftedVertices {
  std::vector<Index> vertex;              ///< #C
  std::vector<Index> moved;               ///< new numbers of all vertices that go with the faces
  std::vector<std::vector<Index>> above;  ///< #V: of old vertices the ones lifted; empty where none is
};

/// The mesh with the region lifted by nothing: every vertex at its old place, walls without area.
struct LiftedMesh {
  MeshEdit edit;
  LiftedVertices vertices;
};

LiftedRegion::LiftedRegion(const MeshTopology& topology, std::span<const Index> faces)
    : topology_(topology), lifted_(topology.face_count(), 0), umbrellas_(topology.corner_count()) {
  for (const Index face : faces) {
    if (face < lifted_.size()) lifted_[face] = 1;
  }
  join_corners();
  find_rims();
}

bool LiftedRegion::empty() const {
  return std::none_of(lifted_.begin(), lifted_.end(), [](char lifted) { return lifted != 0; });
}

bool LiftedRegion::on_rim(Index corner) const {
  const Index edge = topology_.edge(corner);
  if (edge == no_index) return false;
  const auto corners = topology_.edge_corners(edge);
  return corners.size() == 1 ||
         std::any_of(corners.begin(), corners.end(), [&](Index other) { return !lifts(topology_.face(other)); });
}

void LiftedRegion::join_corners() {
  for (Index edge = 0; edge < topology_.edge_count(); ++edge) {
    const auto corners = topology_.edge_corners(edge);
    if (on_rim(corners.front())) continue;
    for (const Index corner : corners.subspan(1)) join(corners.front(), corner);
  }
}

/// Two corners that start the same edge: at each of its ends.
void LiftedRegion::join(Index a, Index b) {
  const bool same_way = topology_.vertex(a) == topology_.vertex(b);
  umbrellas_.unite(a, same_way ? b : topology_.next(b));
  umbrellas_.unite(topology_.next(a), same_way ? topology_.next(b) : b);
}

/// An umbrella parts at the border of the lifted faces, or when other faces share its vertex.
void LiftedRegion::find_rims() {
  for (Index corner = 0; corner < topology_.corner_count(); ++corner) {
    if (!lifts(topology_.face(corner))) continue;
    if (on_rim(corner)) {
      parts_.insert(umbrella(corner));
      parts_.insert(umbrella(topology_.next(corner)));
    }
    for (const Index other : topology_.vertex_corners(topology_.vertex(corner)))
      if (umbrella(other) != umbrella(corner)) parts_.insert(umbrella(corner));
  }
}

LiftedVertices lift_vertices(const MeshTopology& topology, LiftedRegion& region, MeshPlan& plan) {
  LiftedVertices lifted;
  lifted.vertex.resize(topology.corner_count());
  lifted.above.resize(topology.vertex_count());
  std::vector<Index> of_umbrella(topology.corner_count(), no_index);
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    const Index vertex = topology.vertex(corner);
    lifted.vertex[corner] = vertex;
    if (!region.lifts(topology.face(corner))) continue;
    Index& now = of_umbrella[region.umbrella(corner)];
    if (now == no_index) {
      now = vertex;
      if (region.parts(corner)) {
        now = static_cast<Index>(plan.vertices.size());
        plan.vertices.push_back({vertex, no_index, 0});
      }
      lifted.moved.push_back(now);
      lifted.above[vertex].push_back(now);
    }
    lifted.vertex[corner] = now;
  }
  return lifted;
}

void add_faces(MeshPlan& plan, const PolyMesh& mesh, const std::vector<Index>& vertex_of_corner) {
  for (Index face = 0; face < mesh.face_count(); ++face) {
    for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + 1]; ++corner)
      plan.add_corner(vertex_of_corner[corner], {corner, no_index, 0});
    plan.end_face(face);
  }
}

void add_walls(MeshPlan& plan, const MeshTopology& topology, const LiftedRegion& region,
               const std::vector<Index>& vertex_of_corner) {
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    if (!region.lifts(topology.face(corner)) || !region.on_rim(corner)) continue;
    const Index next = topology.next(corner);
    const Blend at_corner{corner, no_index, 0};
    const Blend at_next{next, no_index, 0};
    plan.add_corner(topology.vertex(corner), at_corner);
    plan.add_corner(topology.vertex(next), at_next);
    plan.add_corner(vertex_of_corner[next], at_next);
    plan.add_corner(vertex_of_corner[corner], at_corner);
    plan.end_face(topology.face(corner));
  }
}

TagMap tags_of_lifted(const MeshTopology& topology, const LiftedRegion& region, const LiftedVertices& lifted) {
  TagMap map;
  map.edge = [&](const VertexPair& pair) -> std::vector<VertexPair> {
    const Index edge = find_edge(topology, pair[0], pair[1]);
    std::vector<VertexPair> pairs;
    if (edge == no_index) return {pair};
    for (const Index corner : topology.edge_corners(edge)) {
      if (!region.lifts(topology.face(corner))) continue;
      const VertexPair above = ordered_pair(lifted.vertex[corner], lifted.vertex[topology.next(corner)]);
      if (std::find(pairs.begin(), pairs.end(), above) == pairs.end()) pairs.push_back(above);
    }
    return pairs.empty() ? std::vector<VertexPair>{pair} : pairs;
  };
  map.pin = [&](Index vertex) -> std::vector<Index> {
    if (vertex >= lifted.above.size()) return {};
    return lifted.above[vertex].empty() ? std::vector<Index>{vertex} : lifted.above[vertex];
  };
  return map;
}

/// Vertices that went, and those whose surroundings have other faces now.
std::vector<char> changed_vertices(const LiftedVertices& lifted, std::size_t old_count, std::size_t count) {
  std::vector<char> changed(count, 0);
  for (const Index vertex : lifted.moved) changed[vertex] = 1;
  for (std::size_t vertex = 0; vertex < old_count; ++vertex) {
    if (!lifted.above[vertex].empty()) changed[vertex] = 1;
  }
  return changed;
}

/// Tags of the lifted faces' edges and vertices go with them, the rim's too; the walls' own edges have none.
/// @param region not empty
LiftedMesh lift_region(const PolyMesh& mesh, const MeshTopology& topology, LiftedRegion& region) {
  MeshPlan plan = plan_with_vertices_of(mesh);
  LiftedVertices vertices = lift_vertices(topology, region, plan);
  add_faces(plan, mesh, vertices.vertex);
  add_walls(plan, topology, region, vertices.vertex);
  MeshEdit edit = rebuilt(mesh, plan, all_elements(mesh.vertex_count()));
  for (auto wall = static_cast<Index>(mesh.face_count()); wall < edit.mesh.face_count(); ++wall) {
    edit.face_source[wall] = no_index;
    edit.new_faces.push_back(wall);
  }
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (region.lifts(face)) edit.moved_faces.push_back(face);
  }
  forget_normals(edit.mesh, changed_vertices(vertices, mesh.vertex_count(), edit.mesh.vertex_count()));
  carry_tags(mesh.tags, tags_of_lifted(topology, region, vertices), edit);
  return {std::move(edit), std::move(vertices)};
}

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

MeshEdit extrude_faces(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> faces,
                       const Vec3& offset) {
  LiftedRegion region(topology, faces);
  if (region.empty()) throw Error(make_error(Category::Usage, "E_INPUT", "There is no face to extrude: select some"));
  LiftedMesh result = lift_region(mesh, topology, region);
  for (const Index vertex : result.vertices.moved) result.edit.mesh.positions[vertex] += offset;
  return std::move(result.edit);
}

}  // namespace croquis
