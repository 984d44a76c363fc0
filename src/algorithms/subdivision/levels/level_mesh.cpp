// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/level_mesh.h"

#include <cstdint>
#include <utility>

#include "algorithms/subdivision/refinement/refine.h"
#include "croquis/subdivision/cage.h"

namespace croquis::subdivision {
namespace {

std::vector<Crease> creases_of(const Level& level) {
  const HalfEdges& mesh = level.topology;
  std::vector<Crease> creases;
  creases.reserve(level.sharp.size());
  for (const auto& [edge, sharpness] : level.sharp) {
    const Index corner = mesh.edge_corner[edge];
    creases.push_back({{mesh.corner_vertex[corner], mesh.corner_vertex[mesh.twin[corner]]}, sharpness});
  }
  return creases;
}

/// Only where there is one: most meshes have no such corner.
void add_settled_channel(const Level& level, PolyMesh& mesh) {
  if (level.settled.empty()) return;
  std::vector<std::uint8_t> settled(mesh.vertex_count(), 0);
  for (const Index vertex : level.settled) settled[vertex] = 1;
  mesh.channels.push_back({settled_channel, Domain::Vertex, 1, std::move(settled), {}});
}

}  // namespace

PolyMesh to_mesh(const Level& level, std::span<const Vec3> positions) {
  PolyMesh mesh;
  mesh.positions.assign(positions.begin(), positions.end());
  mesh.face_offsets.assign(level.topology.face_offsets.begin(), level.topology.face_offsets.end());
  mesh.corners.assign(level.topology.corner_vertex.begin(), level.topology.corner_vertex.end());
  mesh.tags.creases = creases_of(level);
  mesh.tags.pins = level.pins;
  add_settled_channel(level, mesh);
  return mesh;
}

PolyMesh to_mesh(const DooSabinPlan& plan, int k, std::span<const Vec3> positions) {
  PolyMesh mesh = to_mesh(plan.level(k), positions);
  std::vector<std::uint32_t> kinds(mesh.face_count()), elements(mesh.face_count()), vertices(mesh.vertex_count());
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const FaceOrigin origin = plan.cage_element(k, face);
    kinds[face] = static_cast<std::uint32_t>(origin.kind);
    elements[face] = origin.element;
  }
  for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex) vertices[vertex] = plan.cage_vertex(k, vertex);
  mesh.channels.push_back({"cage_kind", Domain::Face, 1, std::move(kinds), {"face", "edge", "vertex", "band"}});
  mesh.channels.push_back({"cage_element", Domain::Face, 1, std::move(elements), {}});
  mesh.channels.push_back({"cage_vertex", Domain::Vertex, 1, std::move(vertices), {}});
  return mesh;
}

FaceOrigin LevelOrigins::face(Index face, const HalfEdges& old, const HalfEdges& made) const {
  if (face < old_faces) return {FaceKind::Face, face};
  Index rank = face - old_faces;
  if (rank < quads) {
    const Index old_half_edge = made.twin[quads_begin + 4 * rank];  // corners of old faces keep their numbers
    return {FaceKind::Edge, old.corner_edge[old_half_edge]};
  }
  rank -= quads;
  if (rank < plain_vertices.kept_count()) return {FaceKind::Vertex, plain_vertices.element(rank)};
  return listed_faces[rank - plain_vertices.kept_count()];
}

VertexOrigin LevelOrigins::vertex(Index vertex, const HalfEdges& old) const {
  if (vertex >= own_corners.kept_count()) return listed[vertex - own_corners.kept_count()];
  const Index corner = own_corners.element(vertex);
  return {PointKind::Corner, old.corner_vertex[corner], corner};
}

}  // namespace croquis::subdivision
