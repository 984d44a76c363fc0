// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/cage.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "algorithms/subdivision/cage/cage_checks.h"
#include "croquis/base/error.h"

namespace croquis::subdivision {
namespace {

/// For each corner of the mesh the half-edge of the cage on the same edge: where a face of n corners is turned over,
/// its edge i becomes its edge n-1-i.
std::vector<Index> half_edges_after_turning(const PolyMesh& mesh, const std::vector<bool>& flipped) {
  std::vector<Index> half_edge(mesh.corners.size());
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const Index begin = mesh.face_offsets[face], end = mesh.face_offsets[face + 1];
    for (Index corner = begin; corner < end; ++corner) {
      half_edge[corner] = flipped[face] ? begin + (end - 1 - corner) : corner;
    }
  }
  return half_edge;
}

void turn_faces(const std::vector<bool>& flipped, HalfEdges& topology) {
  for (std::size_t face = 0; face < topology.face_count(); ++face) {
    if (!flipped[face]) continue;
    const auto begin = topology.corner_vertex.begin();
    std::reverse(begin + topology.face_offsets[face] + 1, begin + topology.face_offsets[face + 1]);
  }
}

void number_edges(HalfEdges& topology) {
  topology.corner_edge.resize(topology.corner_count());
  topology.edge_corner.clear();
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    const Index twin = topology.twin[corner];
    if (twin < corner) {
      topology.corner_edge[corner] = topology.corner_edge[twin];
    } else {
      topology.corner_edge[corner] = static_cast<Index>(topology.edge_corner.size());
      topology.edge_corner.push_back(corner);
    }
  }
}

/// All but vertex_corner.
HalfEdges connect(const PolyMesh& mesh, const EdgePairing& pairing, const std::vector<bool>& flipped,
                  const std::vector<Index>& cage_corner) {
  HalfEdges topology;
  topology.face_offsets.assign(mesh.face_offsets.begin(), mesh.face_offsets.end());
  topology.corner_vertex.assign(mesh.corners.begin(), mesh.corners.end());
  turn_faces(flipped, topology);
  topology.twin.assign(mesh.corners.size(), no_index);
  pairing.for_each_edge([&](std::span<const Index> corners) {
    if (corners.size() != 2) return;
    const Index a = cage_corner[corners[0]], b = cage_corner[corners[1]];
    topology.twin[a] = b;
    topology.twin[b] = a;
  });
  number_edges(topology);
  return topology;
}

void take_vertices(const PolyMesh& mesh, VertexFans fans, Cage& cage) {
  cage.source_vertex = std::move(fans.source_vertex);
  cage.positions.reserve(cage.source_vertex.size());
  for (const Index vertex : cage.source_vertex) cage.positions.push_back(mesh.positions[vertex]);
}

/// Corners that an earlier refinement made, of a mesh that to_mesh gave.
void read_settled_corners(const PolyMesh& mesh, Cage& cage) {
  cage.settled.assign(cage.topology.vertex_count(), 0);
  const AttributeChannel* channel = mesh.channel(settled_channel, Domain::Vertex);
  if (channel == nullptr) return;
  const auto* values = std::get_if<std::vector<std::uint8_t>>(&channel->data);
  if (values == nullptr || values->size() != mesh.vertex_count()) return;
  for (std::size_t v = 0; v < cage.settled.size(); ++v) cage.settled[v] = (*values)[cage.source_vertex[v]] != 0;
}

}  // namespace

CageResult make_cage(const PolyMesh& mesh, const Rules& rules, CageUse use) {
  Findings errors = check_values(mesh);
  const auto is_index_error = [](const Finding& finding) { return finding.code == "E_INDEX"; };
  if (std::any_of(errors.begin(), errors.end(), is_index_error)) throw Error(std::move(errors));

  const EdgePairing pairing(mesh, degenerate_faces(mesh));
  const Orientation orientation = orient(mesh, pairing);
  check_sharing(mesh, pairing, errors);
  check_orientable(orientation, errors);
  if (!errors.empty()) throw Error(std::move(errors));

  CageResult result;
  Cage& cage = result.cage;
  const std::vector<Index> cage_corner = half_edges_after_turning(mesh, orientation.flipped);
  cage.topology = connect(mesh, pairing, orientation.flipped, cage_corner);
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (orientation.flipped[face]) cage.flipped_faces.push_back(face);
  }
  tell_flipped(cage.flipped_faces, result.warnings);
  VertexFans fans = split_vertices_into_fans(cage.topology, mesh.vertex_count());
  tell_fans(fans, result.warnings);
  take_vertices(mesh, std::move(fans), cage);

  read_sharpness({mesh, pairing, cage_corner}, cage, result.warnings);
  read_pins(mesh, use, cage, result.warnings);
  read_settled_corners(mesh, cage);
  if (use == CageUse::DooSabin) tell_vanishing_tags(cage, rules, result.warnings);
  tell_reflex_corners(mesh, result.warnings);
  return result;
}

}  // namespace croquis::subdivision
