// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/mesh_report.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/base/described.h"
#include "croquis/geometry/bounds.h"
#include "croquis/geometry/degenerate_faces.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/polygon_cut.h"
#include "croquis/geometry/self_intersection.h"
#include "geometry/require_usable.h"

namespace croquis {
namespace {

void measure(const PolyMesh& mesh, MeshReport& figures) {
  figures.bounds = bounds_of(mesh);
  if (!figures.bounds) return;
  // Far from the origin the cones' volumes would be large and cancel; from the middle they are of the mesh's own size.
  const Vec3 origin = (*figures.bounds)[0] / 2 + (*figures.bounds)[1] / 2;
  double twice_area = 0;
  double six_volumes = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    visit_triangles(mesh.positions, face, [&](const std::array<Index, 3>& t) {
      const Vec3 a = mesh.positions[face[t[0]]] - origin;
      const Vec3 b = mesh.positions[face[t[1]]] - origin;
      const Vec3 c = mesh.positions[face[t[2]]] - origin;
      twice_area += (b - a).cross(c - a).norm();
      six_volumes += a.dot(b.cross(c));
    });
  }
  figures.area = twice_area / 2;
  if (figures.closed) figures.volume = six_volumes / 6;
}

/// How often faces run an edge in its own direction, less how often the other way.
std::ptrdiff_t surplus(const MeshTopology& topology, Index edge) {
  const Index start = topology.edge_vertices(edge)[0];
  std::ptrdiff_t sum = 0;
  for (const Index corner : topology.edge_corners(edge)) sum += topology.vertex(corner) == start ? 1 : -1;
  return sum;
}

/// @return per vertex, whether it is at an edge of more than two faces
std::vector<bool> count_edges(const MeshTopology& topology, MeshReport& figures) {
  std::vector<bool> at_nonmanifold(topology.vertex_count(), false);
  figures.edges = topology.edge_count();
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const std::size_t faces = topology.edge_corners(edge).size();
    if (faces == 1) ++figures.boundary_edges;
    if (faces > 1 && std::abs(surplus(topology, edge)) > 1) figures.oriented = false;
    if (faces <= 2) continue;
    ++figures.nonmanifold_edges;
    for (const Index vertex : topology.edge_vertices(edge)) at_nonmanifold[vertex] = true;
  }
  figures.closed = topology.face_count() > 0 && figures.boundary_edges == 0;
  return at_nonmanifold;
}

/// @param at_nonmanifold see count_edges
/// @return the number of fans of all vertices
std::int64_t count_vertices(const MeshTopology& topology, const std::vector<bool>& at_nonmanifold,
                            MeshReport& figures) {
  std::int64_t fans = 0;
  std::int64_t used = 0;
  for (Index vertex = 0; vertex < topology.vertex_count(); ++vertex) {
    fans += topology.fan_count(vertex);
    if (topology.fan_count(vertex) > 0) ++used;
    if (topology.fan_count(vertex) > 1 || at_nonmanifold[vertex]) ++figures.nonmanifold_vertices;
  }
  figures.euler_characteristic =
      used - static_cast<std::int64_t>(topology.edge_count()) + static_cast<std::int64_t>(topology.face_count());
  return fans;
}

/// Whether turning some faces over could make all of them agree; for meshes without non-manifold edges.
bool orientable(const PolyMesh& mesh, const MeshTopology& topology) {
  enum class Side : char { Unknown, Kept, Turned };
  std::vector<Side> side(topology.face_count(), Side::Unknown);
  std::vector<Index> pending;
  for (Index seed = 0; seed < topology.face_count(); ++seed) {
    if (side[seed] != Side::Unknown) continue;
    side[seed] = Side::Kept;
    pending.push_back(seed);
    while (!pending.empty()) {
      const Index face = pending.back();
      pending.pop_back();
      for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + 1]; ++corner) {
        const Index other = topology.opposite(corner);
        if (other == no_index) continue;
        const bool agree = topology.vertex(corner) != topology.vertex(other);
        const Side wanted = agree == (side[face] == Side::Kept) ? Side::Kept : Side::Turned;
        Side& neighbour = side[topology.face(other)];
        if (neighbour == Side::Unknown)
          pending.push_back(topology.face(other));
        else if (neighbour != wanted)
          return false;
        neighbour = wanted;
      }
    }
  }
  return true;
}

void count_elements(const PolyMesh& mesh, MeshReport& figures) {
  const MeshTopology topology(mesh);
  figures.vertices = mesh.vertex_count();
  figures.faces = mesh.face_count();
  figures.components = topology.component_count();
  figures.boundary_loops = topology.boundary_loops().size();
  figures.degenerate_faces = degenerate_faces(mesh).size();
  const std::vector<bool> at_nonmanifold = count_edges(topology, figures);
  const std::int64_t fans = count_vertices(topology, at_nonmanifold, figures);
  if (!figures.closed || figures.nonmanifold_edges > 0) return;
  if (!figures.oriented && !orientable(mesh, topology)) return;
  // Pulled apart at the vertices where only corners touch, the shells are surfaces: V - E + F = 2 (shells - genus).
  const std::int64_t euler = fans - static_cast<std::int64_t>(figures.edges) + static_cast<std::int64_t>(figures.faces);
  figures.genus = static_cast<std::int64_t>(figures.components) - euler / 2;
}

}  // namespace

MeshReport inspect(const PolyMesh& mesh, bool count_self_intersections, Progress& progress) {
  require_usable(mesh);
  MeshReport figures;
  Progress counting = progress.step("count elements", count_self_intersections ? 0.3 : 1.0);
  count_elements(mesh, figures);
  counting.report(0.8);
  measure(mesh, figures);
  counting.report(1);
  if (count_self_intersections) {
    Progress searching = progress.step("find self-intersections", 0.7);
    figures.self_intersections = find_self_intersections(mesh, searching, {.max_pairs = 0}).count;
  }
  progress.report(1);
  return figures;
}

Report to_report(const MeshReport& figures) {
  return to_report(
      fields(named("vertices", figures.vertices), named("faces", figures.faces), named("edges", figures.edges),
             named("boundary_edges", figures.boundary_edges), named("boundary_loops", figures.boundary_loops),
             named("components", figures.components), named("euler_characteristic", figures.euler_characteristic),
             named("genus", figures.genus), named("nonmanifold_edges", figures.nonmanifold_edges),
             named("nonmanifold_vertices", figures.nonmanifold_vertices),
             named("degenerate_faces", figures.degenerate_faces), named("oriented", figures.oriented),
             named("closed", figures.closed), named("self_intersections", figures.self_intersections),
             named("area", figures.area), named("volume", figures.volume), named("bounds", figures.bounds)));
}

}  // namespace croquis
