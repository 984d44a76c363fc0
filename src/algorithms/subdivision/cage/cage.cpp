// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/cage.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>

#include "algorithms/subdivision/cage/cage_checks.h"
#include "croquis/base/error.h"
#include "croquis/geometry/face_orientation.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis::subdivision {
namespace {

/// For each corner of the mesh the half-edge of the cage on the same edge: where a face of n corners is turned over,
/// its edge i becomes its edge n-1-i.
std::vector<Index> half_edges_after_turning(const PolyMesh& mesh, const std::vector<std::uint8_t>& flipped) {
  std::vector<Index> half_edge(mesh.corners.size());
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const Index begin = mesh.face_offsets[face], end = mesh.face_offsets[face + 1];
    for (Index corner = begin; corner < end; ++corner) {
      half_edge[corner] = flipped[face] != 0 ? begin + (end - 1 - corner) : corner;
    }
  }
  return half_edge;
}

void turn_faces(const std::vector<std::uint8_t>& flipped, HalfEdges& topology) {
  for (std::size_t face = 0; face < topology.face_count(); ++face) {
    if (flipped[face] == 0) continue;
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

/// Each fan of a vertex becomes a vertex of its own: by old vertex, then by lowest corner.
void take_vertices(const PolyMesh& mesh, const MeshTopology& topology, Cage& cage) {
  std::vector<Index> first(mesh.vertex_count());
  for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    first[vertex] = static_cast<Index>(cage.source_vertex.size());
    cage.source_vertex.insert(cage.source_vertex.end(), topology.fan_count(vertex), vertex);
    cage.positions.insert(cage.positions.end(), topology.fan_count(vertex), mesh.positions[vertex]);
  }
  cage.topology.corner_vertex.resize(mesh.corners.size());
  for (Index corner = 0; corner < mesh.corners.size(); ++corner) {
    cage.topology.corner_vertex[corner] = first[mesh.corners[corner]] + topology.fan(corner);
  }
}

/// @param mesh with the vertices of its corners, as the faces were given
void connect(const MeshTopology& topology, const std::vector<std::uint8_t>& flipped,
             const std::vector<Index>& cage_corner, std::size_t vertex_count, HalfEdges& mesh) {
  turn_faces(flipped, mesh);
  mesh.twin.resize(mesh.corner_count());
  for (Index corner = 0; corner < mesh.corner_count(); ++corner) {
    const Index other = topology.opposite(corner);
    mesh.twin[cage_corner[corner]] = other == no_index ? no_index : cage_corner[other];
  }
  number_edges(mesh);
  // From the boundary's half-edge turning counter-clockwise reaches a whole fan, inside from any: the lowest is taken.
  mesh.vertex_corner.resize(vertex_count);
  for (Index corner = static_cast<Index>(mesh.corner_count()); corner-- > 0;) {
    mesh.vertex_corner[mesh.corner_vertex[corner]] = corner;
  }
  for (Index corner = 0; corner < mesh.corner_count(); ++corner) {
    if (mesh.twin[corner] == no_index) mesh.vertex_corner[mesh.corner_vertex[corner]] = corner;
  }
}

/// The faces with three corners or more and no vertex twice, the others empty: all keep their numbers.
PolyMesh without_degenerate_faces(const PolyMesh& mesh) {
  PolyMesh sound;
  sound.positions = mesh.positions;
  sound.face_offsets = {0};
  std::vector<std::size_t> last_face(mesh.vertex_count(), mesh.face_count());
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    bool degenerate = corners.size() < 3;
    for (const Index vertex : corners) {
      degenerate = degenerate || last_face[vertex] == face;
      last_face[vertex] = face;
    }
    if (!degenerate) sound.corners.insert(sound.corners.end(), corners.begin(), corners.end());
    sound.face_offsets.push_back(static_cast<Index>(sound.corners.size()));
  }
  return sound;
}

FaceOrientation orient(const PolyMesh& mesh, const MeshTopology& topology) {
  return orient_faces(mesh.face_count(), [&](Index face, auto&& visit) {
    for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + std::size_t{1}]; ++corner) {
      const Index other = topology.opposite(corner);
      if (other != no_index) visit(corner, topology.face(other), topology.vertex(corner) == topology.vertex(other));
    }
  });
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

  const PolyMesh sound = without_degenerate_faces(mesh);
  const MeshTopology topology(sound);
  const FaceOrientation orientation = orient(sound, topology);
  check_sharing(topology, errors);
  check_orientable(topology, orientation.conflict, errors);
  if (!errors.empty()) throw Error(std::move(errors));

  CageResult result;
  Cage& cage = result.cage;
  const std::vector<Index> cage_corner = half_edges_after_turning(mesh, orientation.turned);
  cage.topology.face_offsets.assign(mesh.face_offsets.begin(), mesh.face_offsets.end());
  take_vertices(mesh, topology, cage);
  connect(topology, orientation.turned, cage_corner, cage.source_vertex.size(), cage.topology);
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (orientation.turned[face] != 0) cage.flipped_faces.push_back(face);
  }
  report_flipped(cage.flipped_faces, result.warnings);
  report_fans(topology, result.warnings);

  read_sharpness(mesh, topology, cage_corner, cage, result.warnings);
  read_pins(mesh, use, cage, result.warnings);
  read_settled_corners(mesh, cage);
  if (use == CageUse::DooSabin) report_vanishing_tags(cage, rules, result.warnings);
  report_reflex_corners(mesh, result.warnings);
  return result;
}

}  // namespace croquis::subdivision
